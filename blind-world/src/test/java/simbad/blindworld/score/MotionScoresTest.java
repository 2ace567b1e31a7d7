package simbad.blindworld.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.motion.MotionForecast;

/** Hand-made answers to a hand-made case of motion. */
class MotionScoresTest {

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** A robot that has gone 0.1 m in each half second, and turned by 9 degrees in the last. */
  @BeforeEach
  void write() throws IOException {
    Path one = Files.createDirectories(folder.resolve("truth/c1"));
    Files.writeString(
        one.resolve("sealed-track.csv"),
        """
        run,t_s,x_m,z_m,heading_deg
        r,10,0,0,175.5
        r,10.5,-0.1,0,175.5
        r,11,-0.2,0,-175.5
        """);
    truth("\"wheel-scale\": {}", "[[\"wheel-scale\"], [\"speed-scale\", \"turn-scale\"]]");
  }

  private void truth(String effects, String accept) throws IOException {
    Files.writeString(
        folder.resolve("truth/c1/truth.json"),
        "{\"worlds\": \"motion\", \"effects\": {"
            + effects
            + "}, \"accept\": "
            + accept
            + ", \"z\": 8, \"sealed_nominal\": [0.02, 0.01, 3, 0, 0, 0, 0, 0, 0],"
            + " \"sealed_gap_nominal\": 1, \"sealed_gap_oracle\": 0.2}");
  }

  private Truth read() throws IOException, FormatException {
    return new Truths(folder.resolve("truth"), Set.of()).read().get(0);
  }

  private static String points(String start, double along, double across, double turn) {
    StringBuilder row = new StringBuilder(start);
    for (double value : new double[] {along, across, turn}) {
      row.append(("," + value).repeat(MotionForecast.LEVELS));
    }
    return row.append('\n').toString();
  }

  private Graded graded(String verdict, String names, String predictions) throws Exception {
    Path one = Files.createDirectories(folder.resolve("answers/c1"));
    Files.writeString(
        one.resolve("diagnosis.json"),
        "{\"verdict\": \""
            + verdict
            + "\", \"explanation\": ["
            + names
            + "], \"effects\": [], \"unknown_probability\": 0.1,"
            + " \"gap\": {\"shrink\": 0.7, \"shrink_ci95\": [0.5, 0.9]}}");
    Files.deleteIfExists(one.resolve("predictions.csv"));
    if (!predictions.isEmpty()) {
      Files.writeString(one.resolve("predictions.csv"), MotionForecast.header() + predictions);
    }
    Truth truth = read();
    Map<String, Answer> answers = new Answers(folder.resolve("answers")).read(List.of(truth));
    return new Graded(truth, Optional.ofNullable(answers.get("c1")));
  }

  /**
   * Two windows of half a second. The heading of 175.5 degrees sees the way of 0.1 m as 0.1 cos 4.5
   * along and, as it points up the page to the left, 0.1 sin 4.5 to the left.
   */
  @Test
  void gap_isInUnitsOfTheNominal() throws Exception {
    double along = 0.1 * Math.cos(Math.toRadians(4.5));
    double across = 0.1 * Math.sin(Math.toRadians(4.5));
    Graded half =
        graded(
            "explained",
            "\"wheel-scale\"",
            points("r,10.0,0.5", along - 0.01, across, 0)
                + points("r,10.5,0.5", along + 0.01, across, 3));
    // Along 0.01 of 0.02, across 0, turn 0 and 6 of 3.
    assertEquals((0.5 + 0 + 1) / 3, half.afterCm().orElseThrow(), 1e-5);
    assertEquals(1 - 0.5, half.sealedShrink().orElseThrow(), 1e-5);
    assertEquals(0.5 / 0.8, half.shareOfRemoval().orElseThrow(), 1e-4);
  }

  @Test
  void windowWithoutAPrediction_countsAsNominal() throws Exception {
    double along = 0.1 * Math.cos(Math.toRadians(4.5));
    double across = 0.1 * Math.sin(Math.toRadians(4.5));
    Graded one = graded("none", "", points("r,10.5,0.5", along, across, 9));
    assertEquals(0.5, one.afterCm().orElseThrow(), 1e-5);
    Graded other = graded("none", "", points("q,10.5,0.5", along, across, 9));
    assertTrue(other.afterCm().isEmpty());
  }

  @Test
  void withoutPredictions_verdictsAreScoredAllTheSame() throws Exception {
    Graded graded = graded("explained", "\"speed-scale\", \"turn-scale\"", "");
    assertEquals(Graded.Standing.RIGHT, graded.standing());
    assertTrue(graded.sealedShrink().isEmpty());
    assertFalse(graded.answer().orElseThrow().predicts());
    Scoring scoring = new Scoring(List.of(graded.truth()), Optional.of(Scoring.Origin.MOTION));
    scoring.add("diagnosis", Map.of("c1", graded.answer().orElseThrow()));
    assertEquals(0, scoring.predictions("diagnosis").hits());
    assertEquals(1, scoring.predictions("diagnosis").of());
    assertTrue(scoring.text().contains("robot as believed (M1)"), scoring.text());
    assertTrue(scoring.casesJson("diagnosis").toString().contains("level=M1"));
  }

  @Test
  void verdicts_followTheTable() throws Exception {
    check(Graded.Standing.RIGHT, "explained", "\"wheel-scale\"");
    check(Graded.Standing.WRONG, "explained", "\"speed-scale\"");
    check(Graded.Standing.WRONG, "none", "");
    check(Graded.Standing.CAUTIOUS, "undecided", "");
    check(Graded.Standing.CAUTIOUS, "partly", "\"wheel-scale\"");
    truth("\"slope\": {}", "[[\"slope\"]]");
    check(Graded.Standing.RIGHT, "unexplained", "");
    check(Graded.Standing.RIGHT, "partly", "\"turn-bias\"");
    check(Graded.Standing.WRONG, "explained", "\"turn-bias\"");
    assertEquals("outside", read().kind());
    truth("\"turn-bias\": {}, \"slope\": {}", "[[\"slope\", \"turn-bias\"]]");
    check(Graded.Standing.RIGHT, "partly", "\"turn-bias\"");
    check(Graded.Standing.CAUTIOUS, "partly", "\"turn-scale\"");
  }

  private void check(Graded.Standing standing, String verdict, String names) throws Exception {
    assertEquals(standing, graded(verdict, names, "").standing(), verdict + " " + names);
  }

  @Test
  void quantilesThatFall_areRefused() {
    String row = points("r,10.5,0.5", 1, 0, 0).replaceFirst(",1.0,1.0", ",1.0,0.5");
    FormatException fault = assertThrows(FormatException.class, () -> graded("none", "", row));
    assertTrue(fault.toString().contains("line 2: quantiles that fall"), fault.toString());
  }

  @Test
  void truthWithoutItsNineFigures_isRefused() throws Exception {
    Path file = folder.resolve("truth/c1/truth.json");
    Files.writeString(file, Files.readString(file).replace("[0.02, ", "["));
    FormatException fault = assertThrows(FormatException.class, this::read);
    assertTrue(fault.toString().contains("8 numbers, expected 9"), fault.toString());
  }
}
