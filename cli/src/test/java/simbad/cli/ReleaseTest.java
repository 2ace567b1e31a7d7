package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two releases of one commit. Each takes minutes: it builds everything in a clone. */
@Tag("full")
class ReleaseTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private String run(Path directory, String... command) throws IOException, InterruptedException {
    Process process =
        new ProcessBuilder(command)
            .directory(directory.toFile())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    process.getOutputStream().close();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), String.join(" ", command) + "\n" + output);
    return output;
  }

  @Test
  void oneCommit_fromTwoFolders_hasTheSameBytes() throws Exception {
    Path project = Path.of("..");
    Path clone = folder.resolve("a clone");
    run(project, "git", "clone", "-q", ".", clone.toString());
    Path first = folder.resolve("first");
    Path second = folder.resolve("second");
    run(project, "./simbad", "release", "--stale-figures", "--out", first.toString());
    run(clone, "./simbad", "release", "--stale-figures", "--out", second.toString());
    run(second, "sha256sum", "-c", "--quiet", "SHA256SUMS");
    String sums = Files.readString(first.resolve("SHA256SUMS"));
    assertEquals(7, sums.lines().count(), sums);
    assertEquals(sums, Files.readString(second.resolve("SHA256SUMS")));
    String jar =
        sums.lines()
            .filter(line -> line.matches(".*\\d(-SNAPSHOT)?\\.jar"))
            .findAny()
            .orElseThrow();
    String commit = run(project, "git", "rev-parse", "HEAD").strip();
    String version = run(second, "java", "-jar", jar.split(" +", -1)[1], "--version");
    assertTrue(version.contains("(commit " + commit + ")"), version);
  }
}
