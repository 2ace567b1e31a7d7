package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The guide's program that asks the diagnosis, as it stands there: run. */
class AskWhyTest {
  private static final Pattern PROGRAM =
      Pattern.compile("```java\\n((?:(?!```).)*class AskWhy.*?)```", Pattern.DOTALL);

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @Test
  void program_saysWhatTheCommandSays() throws Exception {
    Matcher program = PROGRAM.matcher(Files.readString(Path.of("../docs/guide/diagnose.md")));
    assertTrue(program.find());
    String code = program.group(1).substring(program.group(1).lastIndexOf("```java\n") + 1);
    assertTrue(code.lines().count() <= 20, code);
    Path source = Files.writeString(folder.resolve("AskWhy.java"), code);
    Process process =
        new ProcessBuilder(
                SimbadProcess.java(source.toString(), "../data/gap/angle-against-uniform"))
            .redirectErrorStream(true)
            .start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), said);
    assertTrue(
        said.toLowerCase(java.util.Locale.ROOT).startsWith("explained [orientation-shadow]"), said);
  }
}
