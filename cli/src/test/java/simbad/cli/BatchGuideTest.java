package simbad.cli;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.control.Command;
import simbad.experiments.control.ControllerMaker;
import simbad.sonar.sensing.Readings;

/** What the commands and the code of docs/guide/batch.md do, in short. */
class BatchGuideTest {
  private static final Path GUIDE = Path.of("..", "docs", "guide", "batch.md");
  private static final Path TUNING = Path.of("..", "data", "batch", "edge-follower-tuning.json");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static String block(String kind) throws IOException {
    Matcher fence =
        Pattern.compile("```" + kind + "\\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(GUIDE));
    assertTrue(fence.find(), kind);
    return fence.group(1);
  }

  private Path results(String command) throws IOException {
    assertTrue(Files.readString(GUIDE).contains("\n    ./simbad " + command + "\n"), command);
    String[] words = command.split(" ");
    for (int i = 1; i < words.length; i++) {
      words[i] = words[i].startsWith("--") ? words[i] : folder.resolve(words[i]).toString();
    }
    Shell shell = Shell.simbad(words);
    assertEquals(0, shell.status(), shell.err());
    return Path.of(words[words.length - 1]).resolve("results.csv");
  }

  /** Six of its runs, fast ones. */
  @Test
  void tuning_runs() throws IOException {
    String spec = Files.readString(TUNING).replace("[0.02]", "[0.5]");
    Files.createDirectories(folder.resolve("data/batch"));
    Files.writeString(
        folder.resolve("data/batch/edge-follower-tuning.json"),
        spec.replaceFirst("\\{", "{\"sample\": {\"runs\": 6, \"seed\": 1},"));
    Path results = results("batch data/batch/edge-follower-tuning.json --out tuning");
    assertEquals(7, Files.readAllLines(results).size());
    String plot =
        "batch-plot tuning --along crossing_angle_deg --curves curl_rad_per_step --out tuning.svg";
    assertTrue(Files.readString(GUIDE).contains("\n    ./simbad " + plot + "\n"), plot);
    String[] words = plot.split(" ");
    words[1] = folder.resolve(words[1]).toString();
    words[words.length - 1] = folder.resolve("tuning.svg").toString();
    Shell shell = Shell.simbad(words);
    assertEquals(0, shell.status(), shell.err());
    assertTrue(Files.readString(folder.resolve("tuning.svg")).contains("<title>Error against"));
  }

  @Test
  void code_isAControllerMaker() throws Exception {
    Path source = Files.writeString(folder.resolve("ArcMaker.java"), block("java"));
    String classPath = System.getProperty("java.class.path");
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, errors, "-proc:none", "-cp", classPath, source.toString());
    assertEquals(0, status, errors.toString(UTF_8));
    try (URLClassLoader loader =
        new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
      ControllerMaker maker =
          (ControllerMaker) loader.loadClass("ArcMaker").getDeclaredConstructor().newInstance();
      Command command = new Command();
      maker.make(0.1, 0.05, Map.of("turn_deg_per_s", 90.0)).decide(new Readings(1), command);
      assertEquals(
          List.of(0.1, Math.PI / 2), List.of(command.speedMPerS(), command.turnRateRadPerS()));
    }
  }
}
