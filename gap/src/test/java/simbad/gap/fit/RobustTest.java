package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.fixture.Worlds;
import simbad.sonar.fixture.Untimed;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Circumstances;
import simbad.sonar.sensing.MovedObstacle;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Medians and slopes, what is nearest in a cone, which readings are of one placement. */
class RobustTest {
  // ---------------------------------------------------------------- medians

  @Test
  void median_isTheMiddle() {
    assertEquals(3, Robust.median(9, 3, 1));
    assertEquals(2.5, Robust.median(4, 1, 100, 1));
    assertEquals(7, Robust.median(7));
    assertTrue(Double.isNaN(Robust.median()));
    double[] values = {3, 1, 2};
    assertEquals(2, Robust.median(values));
    assertArrayEquals(new double[] {3, 1, 2}, values, "and leaves them as they are");
  }

  /** Of the slopes 2, 2, 2 between three points, and of one point far off, the median is 2. */
  @Test
  void slope_isTheMedianOfPairs() {
    assertEquals(2, Robust.medianSlope(new double[] {1, 3, 7}, new double[] {5, 9, 17}, 0), 1e-12);
    double[] x = {0, 1, 2, 3, 4};
    assertEquals(-0.5, Robust.medianSlope(x, new double[] {1, 0.5, 0, -0.5, 50}, 0), 1e-12);
    // Of 1, 4 and (9 - 1) / 2 - the slopes of 0, 1, 5 at 0, 1, 2 - the middle is 2.5.
    assertEquals(2.5, Robust.medianSlope(new double[] {0, 1, 2}, new double[] {0, 1, 5}, 0), 1e-12);
  }

  /** Only pairs that are further apart have a slope: of the three that of 0 and 2. */
  @Test
  void slope_isOfWhatIsApart() {
    double[] x = {0, 1, 2};
    assertEquals(2.5, Robust.medianSlope(x, new double[] {0, 9, 5}, 1), 1e-12);
    assertTrue(Double.isNaN(Robust.medianSlope(x, new double[] {0, 9, 5}, 2)));
    assertTrue(Double.isNaN(Robust.medianSlope(new double[0], new double[0], 0)));
  }

  // ---------------------------------------------------------------- nearest

  /** Twice the step of 1 cm, which is more than the noise of 5 mm. */
  @Test
  void anotherRange_isTwoStepsAway() {
    SonarSpec steps = Worlds.POST.sensor();
    assertFalse(NearestRange.isAnother(steps, 1, 1.0199));
    assertTrue(NearestRange.isAnother(steps, 1, 1.0201));
    assertTrue(NearestRange.isAnother(steps, 1.0201, 1));
    SonarSpec fine = steps.withResolution(0);
    assertFalse(NearestRange.isAnother(fine, 1, 1.0099));
    assertTrue(NearestRange.isAnother(fine, 1, 1.0101));
    double none = Double.POSITIVE_INFINITY;
    assertTrue(NearestRange.isAnother(steps, 1, none));
    assertTrue(NearestRange.isAnother(steps, none, 1));
    assertFalse(NearestRange.isAnother(steps, none, none));
  }

  /** Posts at the origin and 2 m to the right; faces are 5 cm before their centres. */
  private static SensingSetup posts(int count) {
    Obstacle post = Worlds.POST.scene().obstacles().get(0);
    Obstacle right =
        new Obstacle("right", new Placement(2, 0, 0), post.outline(), post.detection());
    return new SensingSetup(
        Worlds.POST.sensor(), new Scene(List.of(post, right).subList(0, count)), 4);
  }

  /** From x = 1 m to the left, from 0.7 m to the right, from -1 m through both, and away. */
  private static PingLog looks() {
    List<ReadingRow> rows = new ArrayList<>();
    double[][] looks = {{1, 180}, {0.7, 0}, {-1, 0}, {1, 90}};
    for (double[] look : looks) {
      Pose pose = Pose.of(look[0], 0, Math.toRadians(look[1]));
      rows.add(new ReadingRow("r", "s", 0.1 * rows.size(), pose, NoEcho.NO_ECHO));
    }
    return new PingLog(rows);
  }

  @Test
  void inCone_isTheNearestOfAll() {
    Geometry both = new Geometry(looks(), posts(2), List.of());
    assertArrayEquals(
        new double[] {0.95, 1.25, 0.95, Double.POSITIVE_INFINITY},
        IntStream.range(0, 4).mapToDouble(i -> NearestRange.inConeM(both, i)).toArray(),
        1e-9);
    Geometry none = new Geometry(looks(), posts(0), List.of());
    assertEquals(Double.POSITIVE_INFINITY, NearestRange.inConeM(none, 3));
  }

  /** Counter-clockwise from 90 degrees the post at the left comes into the cone. */
  @Test
  void turned_isWhatAnotherHeadingSees() {
    SensingSetup setup = posts(2);
    NominalModel model = new NominalModel(setup.sensor(), setup.scene());
    double turn = Math.PI / 2;
    assertEquals(0.95, NearestRange.turnedM(model, looks(), 3, turn), 1e-9);
    assertEquals(0.95, NearestRange.turnedM(model, looks(), 3, -turn), 1e-9);
    assertEquals(Double.POSITIVE_INFINITY, NearestRange.turnedM(model, looks(), 3, 0));
    assertEquals(1.25, NearestRange.turnedM(model, looks(), 1, 0), 1e-9);
    assertEquals(0.65, NearestRange.turnedM(model, looks(), 1, 2 * turn), 1e-9);
    assertEquals(Double.POSITIVE_INFINITY, NearestRange.turnedM(model, looks(), 1, turn));
  }

  // ---------------------------------------------------------------- placements

  private static Circumstances worded(String word) {
    return new Circumstances(
        true,
        Optional.of(word),
        OptionalDouble.empty(),
        MovedObstacle.UNMOVED,
        OptionalDouble.empty(),
        OptionalDouble.empty());
  }

  private static ReadingRow row(String run, int number, double x, double headingRad) {
    return new ReadingRow(run, "s", number, Pose.of(x, 1, headingRad), NoEcho.NO_ECHO);
  }

  private static List<List<Integer>> pings(PingLog log) {
    return new Placements(log)
        .pings().stream().map(pings -> IntStream.of(pings).boxed().toList()).toList();
  }

  /** By x, and of one place by the heading; in another run it is another placement. */
  @Test
  void placements_areRowsOfOnePose_inTheOrderOfPoses() {
    PingLog log =
        new PingLog(
            List.of(
                row("a", 0, 3, 0),
                row("a", 1, 1, 2),
                row("a", 2, 1, 0.5),
                row("a", 3, 3, 0),
                row("a", 4, 1, 2),
                row("b", 0, 3, 0)));
    assertEquals(List.of(List.of(2), List.of(1, 4), List.of(0, 3), List.of(5)), pings(log));
    Placements placements = new Placements(log);
    assertEquals(4, placements.count());
    assertEquals(
        List.of(2, 1, 0, 2, 1, 3), IntStream.range(0, 6).mapToObj(placements::of).toList());
    assertFalse(placements.areRepeated(), "six readings of four places");
  }

  /** What has one word is one placement, wherever it is said to be; it stands at its least pose. */
  @Test
  void words_makePlacements() {
    List<ReadingRow> rows = new ArrayList<>();
    String[] words = {"far", "near", "far", "near"};
    double[] x = {5, 2, 1, 3};
    for (int i = 0; i < 4; i++) {
      rows.add(row("a", i, x[i], 0).at(Pose.of(x[i], 1, 0), worded(words[i])));
    }
    assertEquals(List.of(List.of(0, 2), List.of(1, 3)), pings(new PingLog(rows)));
    assertFalse(new Placements(new PingLog(rows)).areRepeated(), "of two places");
  }

  @ParameterizedTest
  @ValueSource(ints = {3, 4})
  void repeated_areFourPlacesOfTwoReadings(int places) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 2 * places; i++) {
      rows.add(row("a", i, Math.floorDiv(i, 2), 0));
    }
    assertEquals(places == 4, new Placements(new PingLog(rows)).areRepeated());
    rows.remove(0);
    assertFalse(new Placements(new PingLog(rows)).areRepeated(), "one of them read once");
    List<ReadingRow> said = new ArrayList<>();
    List<ReadingRow> untimed = new ArrayList<>();
    for (int i = 0; i < places; i++) {
      said.add(row("a", i, i, 0).at(Pose.of(i, 1, 0), worded("p" + i)));
      untimed.add(row("a", 0, i, 0).at(Pose.of(i, 1, 0), Untimed.ROW));
    }
    assertEquals(places == 4, new Placements(new PingLog(said)).areRepeated(), "in words");
    assertEquals(places == 4, new Placements(new PingLog(untimed)).areRepeated(), "no times");
  }

  @Test
  void order_changesNothing() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      rows.add(row("a", i, i % 7, i % 2));
    }
    List<List<Integer>> pings = pings(new PingLog(rows));
    assertEquals(14, pings.size());
    Collections.shuffle(rows, new Random(3));
    assertEquals(pings, pings(new PingLog(rows)), "a log is sorted by its times");
  }

  // ---------------------------------------------------------------- one of some

  /** A whole number of groups has one each, up to the last. */
  @ParameterizedTest
  @ValueSource(ints = {2, 3, 5, 7})
  void thinned_hasOneOfEachGroup(int of) {
    for (int groups = 1; groups < 40; groups++) {
      Thinned thinned = new Thinned(of * groups, of);
      assertEquals(groups, IntStream.range(0, of * groups).filter(thinned::holds).count());
    }
  }
}
