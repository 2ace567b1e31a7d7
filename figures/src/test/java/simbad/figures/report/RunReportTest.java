package simbad.figures.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.run.Experiment;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.RunSettings;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;

/** The page of a drive that is too fast for the angle's lobes. */
class RunReportTest {
  private static final RunSettings SETTINGS =
      new RunSettings(
          List.of(named("a <b>")),
          List.of(SensorKind.ORIGINAL, SensorKind.SHADOW),
          Catalogue.srf04(),
          0.3,
          Optional.empty(),
          1);
  private static final RunOrigin ORIGIN = new RunOrigin("1 <i>", SETTINGS);

  @SuppressWarnings("NullAway.Init")
  private static List<RunResult> results;

  @TempDir private Path folder = Path.of("target");

  /** Not where the class begins: the drive's threads would wait for it to have begun. */
  @BeforeAll
  static void drive() {
    results = Experiment.run(SETTINGS, result -> {});
  }

  private static ObstacleType named(String name) {
    ObstacleType angle = Catalogue.find("angle").orElseThrow();
    return new ObstacleType(name, angle.parts(), angle.thresholds());
  }

  private String page(int obstacles) throws IOException {
    Map<String, List<RunResult>> byObstacle = new LinkedHashMap<>();
    for (int i = 0; i < obstacles; i++) {
      ObstacleType type = named("a <b>" + i);
      byObstacle.put(type.name(), results.stream().map(one -> round(type, one)).toList());
    }
    Path file = folder.resolve("report.html");
    ReportPage.write(file, PageTop.RUN, ORIGIN, Map.of(), byObstacle);
    return Files.readString(file);
  }

  private static RunResult round(ObstacleType type, RunResult one) {
    return new RunResult(
        type, one.sensor(), one.trace(), one.errors(), one.map(), one.reductionVsOriginal());
  }

  private static String figure(String page, String label) {
    int from = page.indexOf("aria-label=\"" + label);
    assertTrue(from > 0, label);
    return page.substring(from, page.indexOf("</svg>", from));
  }

  @Test
  void lobesAndWays_standAboveTheErrors() throws IOException {
    String errors = figure(page(1), "Errors and lobes by bearing");
    assertEquals(1, count(errors, "class=\"lobe\""));
    assertTrue(count(errors, "class=\"cut\"") >= 2, "a piece over both graphs");
    assertTrue(count(errors, "class=\"trace shadow\"") >= 2, "its way and its error");
    assertTrue(count(errors, "class=\"trace original\"") >= 2);
    assertEquals(1, count(errors, "class=\"table\""));
    assertTrue(errors.contains("data-from=\"60 0\" data-rows=\"bearings-1\" data-to=\"424 360\""));
  }

  @Test
  void everyBearing_hasItsRow() throws IOException {
    String page = page(1);
    String table = page.substring(page.indexOf("<table id=\"bearings-1\""));
    assertEquals(73, count(table.substring(0, table.indexOf("</table>")), "<tr>"));
  }

  @Test
  void map_saysAtHowManyPlaces() throws IOException {
    String map = figure(page(1), "Where the original belt disagrees");
    int places =
        Pattern.compile("headings: (\\d+) of 6561 places")
            .matcher(map)
            .results()
            .mapToInt(found -> Integer.parseInt(found.group(1)))
            .sum();
    assertEquals(6561, places, "each place has one shade");
  }

  @Test
  void names_stayText() throws IOException {
    String page = page(1);
    assertTrue(page.contains("a &lt;b&gt;0") && page.contains("program 1 &lt;i&gt;"));
    assertFalse(page.contains("a <b>"));
  }

  /** Of two obstacles there are all pictures, of ten no maps, of sixty links alone. */
  @Test
  void page_staysSmall_howeverManyObstaclesThereAre() throws IOException {
    List<Integer> pictures = IntStream.of(1, 10, 60).mapToObj(this::pictures).toList();
    assertEquals(4, pictures.get(0));
    assertTrue(pictures.get(1) >= 20, pictures.toString());
    assertEquals(0, pictures.get(2));
  }

  private int pictures(int obstacles) {
    try {
      String page = page(obstacles);
      assertTrue(page.length() < 300_000, obstacles + " obstacles: " + page.length());
      return count(page, "<figure>");
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static int count(String text, String part) {
    return text.split(Pattern.quote(part), -1).length - 1;
  }

  /** The angle is heard from 3.159 m at most; 0.4, 0.7 and 0.95 of that are drawn. */
  @Test
  void aLevelSensor_isDrawnBesideTheThresholdRule() throws IOException {
    String label = "The level law beside the threshold rule: ";
    assertFalse(page(1).contains(label), "no such sensor");
    ObstacleType type = named("heard");
    RunResult one = results.get(1);
    RunResult level =
        new RunResult(
            type,
            SensorKind.LEVEL,
            one.trace(),
            one.errors(),
            one.map(),
            one.reductionVsOriginal());
    Path file = folder.resolve("level.html");
    ReportPage.write(file, PageTop.RUN, ORIGIN, Map.of(), Map.of("heard", List.of(level)));
    String figure = figure(Files.readString(file), label);

    for (String distance : List.of("1.26 m", "2.21 m", "3.00 m")) {
      assertTrue(figure.contains(">" + distance + "<"), distance);
    }
    assertEquals(5, count(figure, "\"trace level\""), "three by angle, two by distance");
  }

  @Test
  void folder_hasThePageAndItsPictures() throws IOException {
    RunReport.write(folder, ORIGIN, results);
    for (String name : List.of("polar", "errors", "map-original", "map-shadow")) {
      assertTrue(Files.exists(folder.resolve("a <b>").resolve(name + ".svg")), name);
    }
    String print = Files.readString(folder.resolve("a <b>/errors.svg"));
    assertTrue(print.contains("<title>Radial error of the traces"), "for print");
    assertTrue(
        Files.readString(folder.resolve("report.html")).contains("href=\"a &lt;b&gt;/polar.svg\""));
  }
}
