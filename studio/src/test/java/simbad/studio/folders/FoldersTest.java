package simbad.studio.folders;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;

/** What the page is told of a folder. */
class FoldersTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private static Path folder;

  @SuppressWarnings("NullAway.Init")
  private static Folders folders;

  @BeforeAll
  static void write() throws Exception {
    Samples.write(Files.createDirectory(folder.resolve("shown")));
    Files.writeString(Files.createDirectory(folder.resolve("outside")).resolve("journal.txt"), "x");
    Files.createSymbolicLink(folder.resolve("shown/link"), folder.resolve("outside"));
    folders = Folders.of(folder.resolve("shown"), List.of());
  }

  private static String question(String path) throws Exception {
    return MAPPER.writeValueAsString(MAPPER.createObjectNode().put("path", path));
  }

  private static JsonNode open(String path) throws Exception {
    return MAPPER.readTree(folders.open(question(path)));
  }

  @Test
  void list_hasEachKind_andFollowsNoLink() throws Exception {
    JsonNode list = MAPPER.readTree(folders.list());
    List<String> found = new ArrayList<>();
    list.path("folders")
        .forEach(one -> found.add(one.path("path").asText() + " " + one.path("kind").asText()));

    assertEquals(
        List.of(
            Samples.MARKUP + " batch",
            "batch batch",
            "captures/again capture",
            "captures/post capture",
            "diagnoses/again sensing",
            "diagnoses/wall sensing",
            "joint/wall joint",
            "motion/robot motion",
            "motion/second motion",
            "runs/one run",
            "runs/two run"),
        found);
    assertEquals("explained: sound-speed", list.path("folders").get(4).path("about").asText());
    assertEquals("4 runs", list.path("folders").get(1).path("about").asText());
    assertEquals("post · original, shadow", list.path("folders").get(9).path("about").asText());
  }

  /** The page shows what the files say. */
  @Test
  void run_hasTableIntervalErrorsAndTraces() throws Exception {
    JsonNode post = open("runs/one").path("obstacles").get(0);

    assertEquals("[0.0,1.5,1.4,1.6]", post.path("table").get(0).toString());
    assertEquals(36, post.path("table").size());
    assertTrue(post.path("parts").isArray());
    List<String> lines = Files.readAllLines(folder.resolve("shown/runs/one/post/radial.csv"));
    String[] first = lines.get(1).split(",", -1);
    assertEquals(
        Double.parseDouble(first[3]), post.path("errors_m").path("original").get(0).asDouble(), 0);
    long steps =
        Files.readAllLines(folder.resolve("shown/runs/one/post/trace.csv")).stream()
            .filter(line -> line.startsWith("shadow,"))
            .count();
    int shown = post.path("traces").path("shadow").get(0).size();
    assertTrue(shown > 20 && shown <= steps, shown + " of " + steps);
  }

  /** Echoes at 1 to 2 m come too soon by a twentieth, which the fit takes away. */
  @Test
  void sensing_hasItsRowsBeforeAndAfter_andThoseOfItsPlaces() throws Exception {
    JsonNode opened = open("diagnoses/wall");
    JsonNode rows = opened.path("rows");

    assertEquals(60, rows.size());
    assertEquals(25, opened.path("places").get(0).size());
    assertEquals(15, opened.path("places").get(1).size());
    JsonNode row = rows.get(opened.path("places").get(0).get(0).asInt());
    double distanceM = row.get(column(opened, "distance_m")).asDouble();
    assertTrue(distanceM >= 1 && distanceM < 2, row.toString());
    double residualCm = -100 * (distanceM - 0.01) * 17 / 357;
    assertEquals(residualCm, row.get(column(opened, "residual_before_cm")).asDouble(), 0.1);
    assertEquals(0, row.get(column(opened, "residual_after_cm")).asDouble(), 0.1);
    assertTrue(opened.path("missing").asText().isEmpty());
  }

  private static int column(JsonNode opened, String name) {
    List<String> names = new ArrayList<>();
    opened.path("columns").forEach(one -> names.add(one.asText()));
    return names.indexOf(name);
  }

  /** A uniform range of 2.5 m is believed; a faster sound changes no threshold. */
  @Test
  void sensing_hasItsCurves() throws Exception {
    JsonNode wall = open("diagnoses/wall").path("obstacles").get(0);

    assertEquals(Reach.BEARINGS, wall.path("believed_m").size());
    for (int i = 0; i < Reach.BEARINGS; i++) {
      assertEquals(2.5, wall.path("believed_m").get(i).asDouble(), 0.03, "bearing " + 5 * i);
      assertEquals(2.5, wall.path("fitted_m").get(i).asDouble(), 0.03, "bearing " + 5 * i);
    }
  }

  /** Rows of another set, or of this one after a change, would be told as if they were these. */
  @Test
  void sensing_withoutTheVeryData_saysSo(@TempDir Path other) throws Exception {
    Samples.write(other);
    Folders changed = Folders.of(other, List.of());
    Path readings = other.resolve("sets/wall/readings.csv");
    Files.writeString(readings, Files.readString(readings).replace("a,one,0.05", "a,one,0.06"));
    JsonNode opened = MAPPER.readTree(changed.open(question("diagnoses/wall")));

    assertFalse(opened.has("rows"));
    String changes = opened.path("missing").asText();
    assertTrue(changes.contains("other files than were diagnosed"), changes);
    assertTrue(opened.has("obstacles"), "its curves are there");

    Folders alone = Folders.of(other.resolve("diagnoses"), List.of());
    String missing = MAPPER.readTree(alone.open(question("wall"))).path("missing").asText();
    assertTrue(missing.startsWith("no data set 'wall'"), missing);
    Folders beside = Folders.of(other.resolve("diagnoses"), List.of(folder.resolve("shown/sets")));
    assertTrue(MAPPER.readTree(beside.open(question("wall"))).has("rows"));
  }

  @Test
  void batchAndMotion_areHandedOn() throws Exception {
    assertEquals(4, open("batch").path("rows").size());
    assertEquals("mean_abs_cm", open("batch").path("columns").get(8).asText());
    assertEquals("explained", open("motion/robot").path("diagnosis").path("verdict").asText());
  }

  @Test
  void capture_isAsFarAsItsJournal() throws Exception {
    JsonNode state = MAPPER.readTree(folders.capture("captures/post"));

    assertEquals("post", state.path("obstacle").asText());
    assertEquals(61, state.path("pings").asInt());
    assertEquals(4, state.path("bearings").asInt());
  }

  /** Half of the pings at 1.1 m are heard: there is the threshold. */
  @Test
  void capture_saysOfEachBearingWhatCameOfHowManyPings() throws Exception {
    JsonNode capture = open("captures/again");
    JsonNode first = capture.path("bearings").get(0);

    assertEquals(2, capture.path("done").asInt());
    assertEquals(1.1, first.path("threshold_m").asDouble(), 0.02);
    assertTrue(first.path("low_m").asDouble() < 1.1 && first.path("high_m").asDouble() > 1.1);
    assertEquals(30, first.path("pings").asInt());
    assertEquals(15, first.path("heard").asInt());
    assertEquals("[1.1,10,5,true]", first.path("levels").get(1).toString());
    // That of the catalogue's table beside it, if the obstacle is in it.
    assertEquals(
        Catalogue.find("angle").orElseThrow().thresholds().table().valueM(0),
        first.path("table_m").asDouble(),
        1e-9);
    assertFalse(open("captures/post").path("bearings").get(0).has("table_m"));
    assertFalse(capture.path("bearings").get(3).has("threshold_m"));
  }

  /**
   * A tenth slower than told: on the line along is 1/10 of 0.05 m short; the fit has it all. Half a
   * second of the arc begins at 10 s and at each half after it.
   */
  @Test
  void drive_hasItsWindowsBeforeAndAfter() throws Exception {
    for (String path : List.of("motion/robot", "joint/wall")) {
      JsonNode motion = open(path);
      List<String> columns = new ArrayList<>();
      motion.path("window_columns").forEach(name -> columns.add(name.asText()));
      JsonNode first = motion.path("windows").get(0);

      assertEquals(80, motion.path("windows").size(), path);
      assertEquals(2, motion.path("tracks").size());
      assertEquals(-0.005, first.get(columns.indexOf("along_before_m")).asDouble(), 2e-5);
      assertEquals(0, first.get(columns.indexOf("along_after_m")).asDouble(), 2e-5);
      assertEquals(40, motion.path("window_places").get(0).size());
      assertEquals(40, motion.path("window_places").get(1).size());
      for (JsonNode index : motion.path("window_places").get(0)) {
        assertTrue(motion.path("windows").get(index.asInt()).get(1).asDouble() >= 10);
      }
      // Of each run 9 windows end 5.5 to 9.5 s after the start, and 10 after the change at 10 s.
      assertEquals(38, motion.path("window_places").get(3).size());
      for (JsonNode index : motion.path("window_places").get(2)) {
        assertEquals("b", motion.path("windows").get(index.asInt()).get(0).asText());
      }
    }
    assertTrue(open("joint/wall").has("rows"));
  }

  /** Neither dots nor a link lead out, and what is no name is no name. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "..",
        "../outside",
        "runs/../../outside",
        "runs/one/../../../outside",
        "link",
        "/etc",
        "",
        "none",
        "runs/one/errors.json",
        "a\u0000b",
        "./../outside",
        "sets/wall"
      })
  void nothingOutsideIsOpened(String path) throws Exception {
    DataFormatException refused =
        assertThrows(DataFormatException.class, () -> folders.open(question(path)));
    assertFalse(String.valueOf(refused.getMessage()).contains(folder.toString()), path);
    assertThrows(DataFormatException.class, () -> folders.capture(path));
  }

  /** A file in a folder that is a link to elsewhere would be read on behalf of who asks. */
  @Test
  void fileThatLeadsOut_isRefused(@TempDir Path other) throws Exception {
    Samples.write(Files.createDirectory(other.resolve("in")));
    Path results = other.resolve("in/batch/results.csv");
    Files.move(results, other.resolve("secret.csv"));
    Files.createSymbolicLink(results, other.resolve("secret.csv"));
    Folders shown = Folders.of(other.resolve("in"), List.of());

    assertThrows(DataFormatException.class, () -> shown.open(question("batch")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"errors.json", "post/table.csv", "post/radial.csv", "post/trace.csv"})
  void brokenFile_isNamed(String file, @TempDir Path other) throws Exception {
    Samples.write(other);
    Files.writeString(other.resolve("runs/one").resolve(file), "sensor,x_m\nshadow,many\n");
    Folders shown = Folders.of(other, List.of());
    String message =
        String.valueOf(
            assertThrows(DataFormatException.class, () -> shown.open(question("runs/one")))
                .getMessage());

    assertTrue(message.contains(Path.of(file).getFileName().toString()), message);
    assertTrue(MAPPER.readTree(shown.list()).path("folders").size() > 5);
  }

  /** 1,000,000 places on a circle: the whole is thinned, a part of it is as fine as a screen. */
  @Test
  void longTrace_isThinned_andFineWhereSomebodyLooks() {
    DrivenWay trace = new DrivenWay();
    for (int i = 0; i < 1_000_000; i++) {
      trace.add(Math.sin(1e-5 * i), Math.cos(1e-5 * i));
    }
    ArrayNode whole = MAPPER.createArrayNode();
    trace.write(DrivenWay.Box.ALL, whole);
    ArrayNode part = MAPPER.createArrayNode();
    trace.write(new DrivenWay.Box(-0.05, 0.9, 0.05, 1.1), part);

    assertEquals(1_000_000, trace.size());
    assertEquals(1, whole.size());
    assertTrue(whole.get(0).size() > 1500 && whole.get(0).size() <= DrivenWay.MOST);
    assertEquals(1, whole.get(0).get(0).get(1).asDouble(), 1e-6);
    // Nearly 10 rad of a circle pass the top twice: from it at the start, and through it later.
    assertEquals(2, part.size());
    for (JsonNode piece : part) {
      for (int i = 1; i < piece.size(); i++) {
        JsonNode from = piece.get(i - 1);
        JsonNode to = piece.get(i);
        assertTrue(Math.abs(to.get(0).asDouble() - from.get(0).asDouble()) < 0.0005, to::toString);
        assertTrue(Math.abs(to.get(0).asDouble()) < 0.051, to::toString);
      }
    }
  }

  /** A line that crosses a part without a place in it is there as well. */
  @Test
  void lineThatCrossesAPart_isInIt() {
    DrivenWay trace = new DrivenWay();
    trace.add(-1, 0);
    trace.add(1, 0);
    trace.add(1, 5);
    ArrayNode part = MAPPER.createArrayNode();
    trace.write(new DrivenWay.Box(-0.1, -0.1, 0.1, 0.1), part);

    assertEquals("[[[-1.0,0.0],[1.0,0.0]]]", part.toString());
  }

  @Test
  void partOfATrace_isAskedForByItsBox() throws Exception {
    String question = "{\"path\": \"runs/one\", \"obstacle\": \"post\", \"box\": %s}";
    JsonNode part = MAPPER.readTree(folders.trace(question.formatted("[0, 0, 9, 9]")));

    // It drives through that quarter more than once.
    assertTrue(part.path("traces").path("shadow").size() > 1, part.toString());
    for (JsonNode piece : part.path("traces").path("shadow")) {
      for (int i = 1; i + 1 < piece.size(); i++) {
        assertTrue(piece.get(i).get(0).asDouble() > -0.03, piece.get(i)::toString);
      }
    }
    for (String box : List.of("[0, 0, 9]", "7", "[0, 0, 1e99, 9]", "[\"a\", 0, 0, 0]")) {
      assertThrows(DataFormatException.class, () -> folders.trace(question.formatted(box)), box);
    }
    assertThrows(
        DataFormatException.class,
        () -> folders.trace(question.formatted("[0, 0, 9, 9]").replace("post", "../..")));
  }
}
