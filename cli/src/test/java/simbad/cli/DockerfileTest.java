package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class DockerfileTest {
  private static final Path PROJECT = Path.of("..");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** Those that the script without Docker knows. */
  @Test
  void steps_areKnownToTheScript() throws Exception {
    List<String> known = List.of("FROM", "COPY", "WORKDIR", "RUN", "ENTRYPOINT", "CMD");
    for (String line : Files.readAllLines(PROJECT.resolve("Dockerfile"))) {
      boolean isStep = !line.isBlank() && !line.startsWith("#");
      assertTrue(!isStep || known.contains(line.split(" ", 2)[0]), line);
    }
  }

  /** Minutes: it fetches a Debian, a JDK and all libraries, and builds everything. */
  @Test
  @Tag("full")
  void steps_runInABareDebian() throws Exception {
    assumeTrue(Files.isExecutable(Path.of("/usr/sbin/debootstrap")), "debootstrap is not there");
    Process process =
        new ProcessBuilder(
                "bash", "../build-config/dockerfile-test", folder.resolve("root").toString())
            .redirectErrorStream(true)
            .start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), said);
    assertTrue(said.contains("Usage: simbad"), said);
  }
}
