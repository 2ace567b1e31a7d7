package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.lifecycle.AfterContainer;
import net.jqwik.api.lifecycle.BeforeContainer;
import simbad.experiments.dataset.MadeDataSet;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** Broken and odd data sets: status 2 with a line that names the file, or a verdict; no crash. */
class BrokenDataTest {
  private static final List<ReadingRow> ROWS = BenchData.rows(30, 0.05);

  /** Enough that some can be tested on what was fitted to others. */
  private static final List<ReadingRow> ENOUGH = BenchData.rows(60, 0.05);

  private static final List<String> JUNK = Junk.and("{", "]", "null", "[]", "true");

  private static Path scratch = Path.of("");

  @BeforeContainer
  static void makeScratch() throws IOException {
    scratch = Files.createTempDirectory("broken");
  }

  @AfterContainer
  static void discardScratch() throws IOException {
    deleteAll(scratch);
  }

  private static void deleteAll(Path root) throws IOException {
    try (Stream<Path> entries = Files.walk(root)) {
      for (Path path : entries.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    }
  }

  private static Shell diagnose(Path data) throws IOException {
    Path out = scratch.resolve("out");
    Shell shell = Shell.simbad("diagnose", data.toString(), "--out", out.toString());
    if (Files.exists(out)) {
      deleteAll(out);
    }
    return shell;
  }

  /** Status 2 and one line that names a file, or 0 and one line with a verdict. */
  private static void checkHonest(Shell shell, Path data) {
    if (shell.status() == 2) {
      assertEquals(1, shell.complaints().size(), shell.err());
      assertTrue(shell.err().startsWith("simbad diagnose: " + data), shell.err());
      assertTrue(shell.err().length() < 1100, shell.err());
      assertEquals("", shell.out());
    } else {
      assertEquals(0, shell.status(), shell.err());
      assertTrue(
          shell.out().matches("(?s)[^:]*: (none|explained|unexplained|undecided).*"), shell.out());
      assertEquals("", shell.err());
    }
  }

  @Property(tries = 60, seed = "4711", shrinking = ShrinkingMode.OFF)
  void junkAnywhere_isSaidOrSurvived(@ForAll Random random) throws IOException {
    Path data = BenchData.write(scratch.resolve("junk"), ROWS);
    Path file = data.resolve(random.nextInt(3) == 0 ? "readings.csv" : "scene.json");
    StringBuilder text = new StringBuilder(Files.readString(file));
    for (int i = 0; i <= random.nextInt(2); i++) {
      int from = random.nextInt(text.length());
      int to = Math.min(text.length(), from + random.nextInt(6));
      text.replace(from, to, JUNK.get(random.nextInt(JUNK.size())));
    }
    Files.writeString(file, text, StandardCharsets.UTF_8);
    checkHonest(diagnose(data), data);
    deleteAll(data);
  }

  @Property(tries = 25, seed = "4712", shrinking = ShrinkingMode.OFF)
  void fieldReplaced_isSaidOrSurvived(@ForAll Random random) throws IOException {
    Path data = BenchData.write(scratch.resolve("field"), ROWS);
    Path file = data.resolve("readings.csv");
    List<String> lines = Files.readAllLines(file);
    int line = 1 + random.nextInt(lines.size() - 1);
    String[] fields = lines.get(line).split(",", -1);
    fields[random.nextInt(fields.length)] = JUNK.get(random.nextInt(JUNK.size()));
    lines.set(line, String.join(",", fields));
    Files.write(file, lines);
    checkHonest(diagnose(data), data);
    deleteAll(data);
  }

  /** Sound files of odd worlds get a verdict. */
  private static String verdict(String name, SensingSetup setup, List<ReadingRow> rows)
      throws IOException {
    Path data = Files.createDirectory(scratch.resolve(name));
    new MadeDataSet(setup, rows).write(data);
    Shell shell = diagnose(data);
    deleteAll(data);
    assertEquals(0, shell.status(), shell.err());
    return shell.out().replaceAll("(?s)^[^:]*: (\\w+).*", "$1");
  }

  private static List<ReadingRow> reading(Reading reading) {
    return ENOUGH.stream()
        .map(row -> new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading))
        .toList();
  }

  @Example
  void oneRow_isTooFewToTell() throws IOException {
    assertEquals("undecided", verdict("one", BenchData.SETUP, ROWS.subList(0, 1)));
  }

  @Example
  void emptyScene_silent_isNone() throws IOException {
    SensingSetup empty = new SensingSetup(BenchData.SETUP.sensor(), new Scene(List.of()), 4);
    assertEquals("none", verdict("empty", empty, reading(NoEcho.NO_ECHO)));
  }

  /** Of a log that is one number no reading can be believed. */
  @Example
  void oneNumberForAll_isRefused() throws IOException {
    for (double range : new double[] {0, 1, 1000}) {
      Path data = Files.createDirectory(scratch.resolve("all-" + range));
      new MadeDataSet(BenchData.SETUP, reading(new Echo(range))).write(data);
      Shell shell = diagnose(data);
      deleteAll(data);
      assertEquals(2, shell.status(), shell.err());
      assertTrue(shell.err().contains("readings.csv:2: range_m: 60 readings"), shell.err());
    }
  }

  @Example
  void silence_getsAVerdict() throws IOException {
    verdict("silent", BenchData.SETUP, reading(NoEcho.NO_ECHO));
  }

  @Example
  void nothingInRange_isNone() throws IOException {
    List<ReadingRow> away =
        ENOUGH.stream()
            .map(
                row ->
                    new ReadingRow(
                        "r", "s", row.timeS(), Pose.of(50 + row.timeS(), 0, 0), NoEcho.NO_ECHO))
            .toList();
    assertEquals("none", verdict("away", BenchData.SETUP, away));
  }
}
