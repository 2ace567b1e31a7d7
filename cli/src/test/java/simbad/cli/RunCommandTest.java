package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ForkJoinPool;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The main job from the command line, on a small table and at a high speed so that it is short. */
class RunCommandTest {
  private static final String HEAD = "bearing_deg,threshold_m\n";

  /** 20 to 30 cm in eight directions. */
  private static final String SMALL =
      "# provenance: captured\n# source: <a & b>\n"
          + HEAD
          + "0,0.3\n45,0.2\n90,0.25\n135,0.3\n180,0.2\n225,0.3\n270,0.2\n315,0.25\n";

  private static final List<String> FILES =
      List.of(
          "errors.csv",
          "errors.json",
          "report.html",
          "run.log",
          "small",
          "small/errors.png",
          "small/errors.svg",
          "small/map-original.png",
          "small/map-original.svg",
          "small/map-shadow.png",
          "small/map-shadow.svg",
          "small/map.csv",
          "small/polar.png",
          "small/polar.svg",
          "small/radial.csv",
          "small/table.csv",
          "small/trace.csv");

  /** What errors.json says of each run; other programs read these. */
  private static final List<String> FIELDS =
      List.of(
          "obstacle",
          "sensor",
          "mean_abs_cm",
          "rms_cm",
          "max_abs_cm",
          "median_abs_cm",
          "lateral_mean_cm",
          "lateral_p95_cm",
          "edge_kept",
          "edge_to_trace_mean_cm",
          "edge_to_trace_max_cm",
          "unreached_bearings",
          "reduction_vs_original",
          "steps",
          "simulated_s");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Path table(String name, String text) throws IOException {
    return Files.writeString(folder.resolve(name), text);
  }

  /** Runs with a speed of 0.1 m/s, the folder out and further arguments. */
  private Shell run(String out, Object... further) {
    List<String> arguments =
        new ArrayList<>(List.of("run", "--speed", "0.1", "--out", folder.resolve(out).toString()));
    Stream.of(further).map(Object::toString).forEach(arguments::add);
    return Shell.simbad(arguments.toArray(String[]::new));
  }

  private static void checkDone(Shell shell) {
    assertEquals(0, shell.status(), shell.err());
    assertEquals("", shell.err());
  }

  private List<String> names(String out) throws IOException {
    Path root = folder.resolve(out);
    try (Stream<Path> entries = Files.walk(root)) {
      return entries.skip(1).map(p -> root.relativize(p).toString()).sorted().toList();
    }
  }

  private JsonNode errors(String out) throws IOException {
    return new ObjectMapper().readTree(folder.resolve(out).resolve("errors.json").toFile());
  }

  @Test
  void ownTable_allFilesAndFieldsAreThere() throws IOException {
    Shell shell = run("out", table("small.csv", SMALL), "--seed", 7);
    checkDone(shell);
    assertEquals(FILES, names("out"));
    assertTrue(shell.out().contains("small (captured)"), shell.out());
    JsonNode errors = errors("out");
    assertEquals("sonar-run/1", errors.get("format").asText());
    assertEquals(7, errors.get("seed").asInt());
    assertEquals(0.1, errors.get("speed_m_per_s").asDouble());
    assertEquals(64, errors.get("table_sha256").get("small").asText().length());
    assertEquals(2, errors.get("results").size());
    errors.get("results").forEach(RunCommandTest::checkFields);
    checkFigures(errors.get("results").get(0), errors.get("results").get(1));
    checkPage();
  }

  private static void checkFields(JsonNode row) {
    FIELDS.forEach(name -> assertTrue(row.hasNonNull(name), name + " in " + row));
  }

  /**
   * The original sensor hears the post to 2.5 m to its surface, 2.51 to its centre, so its radial
   * errors are 2.51 less 0.2 to 0.3 m. One step at 0.1 m/s is 5 mm, and so the shadow sensor's
   * trace is within a few of those.
   */
  private static void checkFigures(JsonNode original, JsonNode shadow) {
    assertEquals("original", original.get("sensor").asText());
    assertEquals(251 - 25, original.get("mean_abs_cm").asDouble(), 3);
    assertEquals(0, original.get("reduction_vs_original").asDouble());
    assertEquals("shadow", shadow.get("sensor").asText());
    assertEquals(0, shadow.get("unreached_bearings").asInt());
    assertTrue(shadow.get("lateral_mean_cm").asDouble() < 1.5, shadow.toString());
    assertEquals(1, shadow.get("edge_kept").asDouble());
    assertTrue(original.get("edge_kept").asDouble() < 0.1, "it follows no table: " + original);
    double expected =
        1 - shadow.get("mean_abs_cm").asDouble() / original.get("mean_abs_cm").asDouble();
    assertEquals(expected, shadow.get("reduction_vs_original").asDouble(), 1e-4);
    assertEquals(shadow.get("steps").asInt() * 0.05, shadow.get("simulated_s").asDouble(), 0.011);
    assertEquals(1, shadow.get("map_agreement").asDouble(), 0.02);
  }

  /** 1.5 cm a step is too fast for the angle's lobes, and every output says so. */
  @Test
  void edgeThatIsNotKept_isSaidPlainly() throws IOException {
    Path out = folder.resolve("fast");
    Shell shell =
        Shell.simbad(
            "run", "angle", "--sensor", "shadow", "--speed", "0.3", "--out", out.toString());
    checkDone(shell);
    JsonNode row = errors("fast").get("results").get(0);
    assertTrue(row.get("edge_kept").asDouble() < 0.95, row.toString());
    String lost = "angle, shadow: the robot did not keep the edge; it came within 5 cm of ";
    assertTrue(shell.out().contains(lost), shell.out());
    assertTrue(Files.readString(out.resolve("report.html")).contains("<p class=\"note\">" + lost));
  }

  private void checkPage() throws IOException {
    String page = Files.readString(folder.resolve("out/report.html"));
    assertTrue(page.contains("No robot was ever traced round these obstacles in reality"));
    assertTrue(page.contains("&lt;a &amp; b&gt;"), "the source is escaped");
    String outside = page.replace("'http://www.w3.org/2000/svg'", "a name, which is not fetched");
    assertFalse(outside.contains("http://") || outside.contains("https://"), "no network");
  }

  private List<byte[]> allButTheLog(String out) throws IOException {
    List<byte[]> contents = new ArrayList<>();
    for (String name : names(out)) {
      Path file = folder.resolve(out).resolve(name);
      if (Files.isRegularFile(file) && !name.equals("run.log")) {
        contents.add(Files.readAllBytes(file));
      }
    }
    return contents;
  }

  /** The tasks of a parallel stream run in the pool from which it is started. */
  private void runIn(int threads, String out, Path table) throws Exception {
    ForkJoinPool pool = new ForkJoinPool(threads);
    try {
      checkDone(pool.submit(() -> run(out, table, "--sensor", "noisy,shadow", "--seed", 3)).get());
    } finally {
      pool.shutdown();
    }
  }

  @Test
  void sameSeed_sameBytesWithOneAndTwoThreads() throws Exception {
    Path table = table("small.csv", SMALL);
    runIn(1, "one", table);
    runIn(2, "two", table);
    List<byte[]> one = allButTheLog("one");
    List<byte[]> two = allButTheLog("two");
    assertEquals(names("one"), names("two"));
    assertEquals(15, one.size());
    for (int i = 0; i < one.size(); i++) {
      assertArrayEquals(one.get(i), two.get(i), names("one").toString() + " file " + i);
    }
    checkDone(run("other", table, "--sensor", "noisy,shadow", "--seed", 4));
    assertNotEquals(
        Files.readString(folder.resolve("one/small/trace.csv")),
        Files.readString(folder.resolve("other/small/trace.csv")));
  }

  /** Spreadsheets write a byte order mark and CRLF: read as the same table. */
  @Test
  void byteOrderMarkAndCrLf_areAccepted() throws IOException {
    checkDone(run("plain", table("small.csv", SMALL), "--sensor", "shadow"));
    Path marked = Files.createDirectory(folder.resolve("other")).resolve("small.csv");
    Files.writeString(marked, "\uFEFF" + SMALL.replace("\n", "\r\n"));
    checkDone(run("marked", marked, "--sensor", "shadow"));
    assertArrayEquals(
        Files.readAllBytes(folder.resolve("plain/small/trace.csv")),
        Files.readAllBytes(folder.resolve("marked/small/trace.csv")));
  }

  /** A threshold of 0 everywhere never echoes: the run ends, nothing is reached, and it says so. */
  @Test
  void zeroEverywhere_isNeverHeard() throws IOException {
    Path table = table("zero.csv", HEAD + "0,0\n90,0\n180,0\n270,0\n");
    Shell shell =
        Shell.simbad(
            "run",
            table.toString(),
            "--speed",
            "1",
            "--sensor",
            "shadow,noisy",
            "--out",
            folder.resolve("out").toString());
    checkDone(shell);
    for (JsonNode row : errors("out").get("results")) {
      assertEquals(4, row.get("unreached_bearings").asInt());
      assertTrue(row.get("mean_abs_cm").isNull());
      assertTrue(row.get("lateral_mean_cm").isNull());
      assertFalse(row.get("closed").asBoolean());
      assertEquals(1, row.get("map_agreement").asDouble());
    }
    String page = Files.readString(folder.resolve("out/report.html"));
    assertTrue(page.contains("did not complete its round: 4 of 4 bearings"), page);
  }

  @Test
  void existingOut_isUntouched() throws IOException {
    Path out = Files.createDirectory(folder.resolve("out"));
    Files.writeString(out.resolve("theirs"), "kept");
    Shell shell = run("out", table("small.csv", SMALL));
    assertEquals(2, shell.status());
    assertEquals(
        List.of("simbad run: --out: " + out + ": exists already"), shell.complaints(), shell.err());
    assertEquals(List.of("theirs"), names("out"));
    Files.writeString(folder.resolve("file"), "kept");
    assertEquals(2, run("file", folder.resolve("small.csv")).status());
    assertEquals("kept", Files.readString(folder.resolve("file")));
  }

  static Stream<String> badUsage() {
    return Stream.of(
        "--speed nan",
        "--speed NaN",
        "--speed 0",
        "--speed -1",
        "--speed 1e9",
        "--speed Infinity",
        "--speed fast",
        "--start junk",
        "--start 1",
        "--start 1,2,3",
        "--start ,",
        "--start NaN,1",
        "--start 1,Infinity",
        "--start 1;2",
        "--start 1e300,0",
        "--start 0,-100.1",
        "--sensor sonar",
        "--sensor shadow,shadow",
        "--sensor SHADOW",
        "--sensor-file /nowhere/sensor.json",
        "--seed 1.5",
        "--seed 99999999999999999999",
        "--colour red");
  }

  @ParameterizedTest
  @MethodSource("badUsage")
  void badUsage_oneLineAndNothingWritten(String arguments) {
    String out = folder.resolve("out").toString();
    String[] words = arguments.split(" ", 2);
    Shell shell = Shell.simbad("run", "round", words[0], words[1], "--out", out);
    assertAll(
        () -> assertEquals(2, shell.status(), shell.err()),
        () -> assertEquals(1, shell.complaints().size(), shell.err()),
        () -> assertTrue(shell.err().contains(words[0]) || shell.err().contains(words[1])),
        () -> assertEquals("", shell.out()),
        () -> assertFalse(Files.exists(Path.of(out))));
  }

  /** Nothing is heard at the start, 1 m out of a shadow of 0.3 m: the robot drives in. */
  @Test
  void startWhereNothingIsHeard_getsRound() throws IOException {
    Path table = table("small.csv", SMALL);
    Shell shell = run("out", table, "--sensor", "shadow", "--start", "0.4,-0.9");
    checkDone(shell);
    assertEquals(0, errors("out").get("results").get(0).get("unreached_bearings").asInt());
  }

  /** No table takes the name of a result. */
  @ParameterizedTest
  @ValueSource(strings = {"errors.json.csv", "run.log.csv", "...csv"})
  void awkwardTableNames_becomeFolders(String name) throws IOException {
    checkDone(run("out", table(name, SMALL), "--sensor", "shadow"));
    assertEquals(
        1,
        names("out").stream().filter(path -> path.endsWith("/polar.png")).count(),
        names("out").toString());
  }
}
