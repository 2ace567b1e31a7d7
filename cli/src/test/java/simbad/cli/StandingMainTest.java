package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A process that does commands one after the other, as a child of one that may be killed. */
class StandingMainTest {
  private static final long PATIENCE_S = 60;

  @TempDir private Path folder = Path.of("");
  private @Nullable Process process;

  @BeforeEach
  void start() throws IOException {
    process = new ProcessBuilder(JavaProgram.standing().command()).start();
  }

  @AfterEach
  void end() {
    process().destroyForcibly();
  }

  private Process process() {
    return Objects.requireNonNull(process);
  }

  private void command(String words) throws IOException {
    Writer in = process().outputWriter(StandardCharsets.UTF_8);
    in.write(words.replace(' ', '\t') + "\n");
    in.flush();
  }

  @Test
  void commands_areDoneInTheirOrder() throws IOException {
    command("table show nothing-of-the-kind");
    command("effects gain");
    BufferedReader said = process().inputReader(StandardCharsets.UTF_8);
    assertTrue(said.readLine().contains("nothing-of-the-kind"));
    assertEquals("ended with status 2", said.readLine());
    assertEquals("ended with status 0", said.readLine());
  }

  /** Whoever is killed closes its end: nobody waits for what is under way any more. */
  @Test
  void endOfInput_endsWhatIsUnderWay() throws Exception {
    Path out = folder.resolve("out");
    command("run angle --sensor overlap --speed 0.0001 --out " + out);
    while (!isBegun()) {
      assertTrue(process().isAlive());
      Thread.sleep(50);
    }
    process().getOutputStream().close();
    assertTrue(process().waitFor(PATIENCE_S, TimeUnit.SECONDS), "it goes on without anybody");
    assertTrue(Files.notExists(out));
  }

  private boolean isBegun() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.findAny().isPresent();
    }
  }
}
