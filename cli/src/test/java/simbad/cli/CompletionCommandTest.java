package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CompletionCommandTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** What bash offers at the end of a line. */
  private String completed(String... words) throws IOException, InterruptedException {
    Shell shell = Shell.simbad("completion");
    assertEquals(0, shell.status(), shell.err());
    Path script = Files.writeString(folder.resolve("completion"), shell.out());
    String line = String.join(" ", words);
    Process bash =
        new ProcessBuilder(
                "bash",
                "-c",
                "source \"$0\"; COMP_WORDS=($1 ''); COMP_CWORD="
                    + words.length
                    + "; _complete_simbad; echo \"${COMPREPLY[*]}\"",
                script.toString(),
                line)
            .redirectErrorStream(true)
            .start();
    bash.getOutputStream().close();
    String output = new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, bash.waitFor(), output);
    return output;
  }

  @Test
  void bash_offersCommands() throws Exception {
    String offered = completed("simbad");
    assertTrue(offered.contains("diagnose") && offered.contains("batch"), offered);
  }

  @Test
  void bash_offersEffectsAndSensors() throws Exception {
    String effects = completed("simbad", "effects");
    assertTrue(effects.contains("gain") && effects.contains("wave-hop"), effects);
    String sensors = completed("simbad", "run", "--sensor");
    assertTrue(sensors.contains("shadow") && sensors.contains("level-noisy"), sensors);
  }

  @Test
  void bash_offersSubcommands() throws Exception {
    String offered = completed("simbad", "table");
    assertTrue(offered.contains("predict") && offered.contains("plot"), offered);
  }
}
