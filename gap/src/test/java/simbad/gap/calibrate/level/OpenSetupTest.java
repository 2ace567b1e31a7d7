package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.LevelWorlds;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelRule;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/**
 * A set-up that a fit knows exactly: only what differs from day to day is left open, and where the
 * law is a little wrong. Pings look straight at posts that are heard up to 1.5 m from their
 * centres, so that the excess there is 0 dB.
 */
class OpenSetupTest {
  private static final double EXACT = 1e-6;
  private static final SonarSpec SENSOR = LevelWorlds.POST.sensor();

  /** Half of a day's 0.3 dB. */
  private static final double LEVEL = 0.15 * 0.15;

  /** The least that levels are off at one place. */
  private static final double PLACE = 0.05 * 0.05;

  /** Two places by tape, and what comes from beyond a post's nearest point. */
  private static final double RANGE = 2 * 0.002 * 0.002 + 0.09 * 0.005;

  private static final double AIR = 0.0009 * 0.0009;

  private static SensingSetup posts(double... centresZ) {
    Obstacle post = LevelWorlds.POST.scene().obstacles().get(0);
    List<Obstacle> all = new ArrayList<>();
    for (double z : centresZ) {
      Placement at = new Placement(0, z, 0);
      all.add(new Obstacle("post " + all.size(), at, post.outline(), post.detection()));
    }
    return new SensingSetup(SENSOR, new Scene(all), 4);
  }

  private static Leeway leeway(int posts, double excessDb, double rangeM) {
    List<Believed> targets = new ArrayList<>();
    for (int i = 0; i < posts; i++) {
      targets.add(new Believed(LevelWorlds.POST.scene().obstacles().get(0), SENSOR));
    }
    Layout layout = new Layout(targets);
    Predictor predictor = LevelPosts.predictor(targets);
    Ranges none = Ranges.of(predictor, List.of(), targets, SENSOR);
    Ranges known = new Ranges(1, none.byLevel(), none.nearM(), none.byBearing(), tiny(10));
    return Leeway.of(
        new Leeway.Known(layout, predictor, tiny(layout.size()), known), excessDb, rangeM);
  }

  /** Known exactly, as far as an inverse can say so. */
  private static RealMatrix tiny(int size) {
    return MatrixUtils.createRealIdentityMatrix(size).scalarMultiply(1e-10);
  }

  private static Leeway.Pulls pulls(
      Leeway leeway, SensingSetup setup, double addedDb, double[] fromZ, double... readM) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < fromZ.length; i++) {
      Reading read = readM[i] > 0 ? new Echo(readM[i]) : NoEcho.NO_ECHO;
      rows.add(new ReadingRow("r", "s", 0.1 * i, Pose.of(0, fromZ[i], Math.PI / 2), read));
    }
    PingLog log = new PingLog(rows);
    double[] added = new double[log.size() * setup.scene().obstacles().size()];
    Arrays.fill(added, addedDb);
    return leeway.pulls(new Geometry(log, setup, List.of(LevelRule.of(SENSOR))), added);
  }

  private static Leeway.Pulls onePing(Leeway leeway, double fromZ, double readM) {
    return pulls(leeway, posts(0), 0, at(fromZ), readM);
  }

  private static double[] at(double... z) {
    return z;
  }

  /** Each reading is likeliest 3 dB further on, with a deviation of 1 dB: a slope of 3, a bend. */
  private static EchoCurves curves(int readings) {
    return new EchoCurves(
        decibels -> {
          double[] values = new double[readings];
          Arrays.fill(values, -(decibels - 3) * (decibels - 3) / 2);
          return values;
        });
  }

  /** At 1 m the air takes 2 dB less by 1 dB per metre: the square of 1 m times 0.05 dB. */
  @Test
  void levelsDifferByTheDay() {
    Leeway leeway = leeway(1, 0, 0);
    assertEquals(LEVEL, levelVariance(leeway, 1.5, 1), EXACT);
    assertEquals(LEVEL + 0.0025, levelVariance(leeway, 1, 1), EXACT);
    assertEquals(4 * LEVEL, levelVariance(leeway, 1.5, 2), EXACT);
    assertEquals(0, levelVariance(leeway, 1.5, 0), 0);
  }

  /** Half a decibel that the law is off; at another distance the receiver's is another. */
  @Test
  void whereTheLawIsWrongLevelsDifferByMore() {
    assertEquals(LEVEL + 0.25, levelVariance(leeway(1, 0.5, 0), 1.5, 1), EXACT);
    // At 0.9 m one knot counts; at 1.5 m two, by the logarithm.
    double share = Math.log(1.5 / 1.3) / Math.log(1.9 / 1.3);
    double knots = 1 + share * share + (1 - share) * (1 - share);
    assertEquals(
        LEVEL + 1.44 * 0.0025 + 0.25 * (1 + knots),
        levelVariance(leeway(1, 0.5, 0), 0.9, 1),
        EXACT);
  }

  private static double levelVariance(Leeway leeway, double fromZ, double rise) {
    Leeway.Together sum = leeway.together(onePing(leeway, fromZ, 0));
    sum.add(0, rise, 1);
    assertEquals(0, sum.rangeVariance(), 0, "nothing was read");
    return sum.levelVariance();
  }

  /** Pings that are off together, and pings of which one rises as the other falls. */
  @Test
  void whatIsOffTogetherAddsUp() {
    Leeway leeway = leeway(1, 0, 0);
    Leeway.Pulls two = pulls(leeway, posts(0), 0, at(1.5, 1.5), 0, 0);
    Leeway.Together sum = leeway.together(two);
    sum.add(0, 1, 0);
    sum.add(1, 1, 0);
    assertEquals(4 * LEVEL, sum.levelVariance(), EXACT);
    sum.add(1, -2, 0);
    assertEquals(0, sum.levelVariance(), EXACT);
  }

  /** 1 m of air, two places, and the post's depth. */
  @Test
  void rangesDifferByTheDay() {
    assertEquals(AIR + RANGE, rangeVariance(leeway(1, 0, 0), 0, 1), 2e-8);
    assertEquals(9 * (AIR + RANGE), rangeVariance(leeway(1, 0, 0), 0, 3), 2e-7);
  }

  /** 1 cm that ranges are off: once for all of them and once for all of one level. */
  @Test
  void whereTheLawIsWrongRangesDifferByMore() {
    Leeway leeway = leeway(1, 0, 0.01);
    assertEquals(AIR + RANGE + 2e-4, rangeVariance(leeway, 60, 1), 2e-8);
  }

  private static double rangeVariance(Leeway leeway, double addedDb, double rise) {
    Leeway.Together sum = leeway.together(pulls(leeway, posts(0), addedDb, at(1.05), 1));
    sum.add(0, 0, rise);
    assertEquals(0, sum.levelVariance(), 0);
    return sum.rangeVariance();
  }

  /**
   * What is read near a post is about that one; silence about the nearest; a stranger is none's.
   */
  @Test
  void aPingIsMostAboutOneLine() {
    Leeway leeway = leeway(2, 0, 0);
    Leeway.Pulls pulls = pulls(leeway, posts(0, -0.5), 0, at(1, 1, 1, 1), 0.95, 1.47, 0, 1.2);

    assertEquals(0, pulls.line(0));
    assertEquals(3, pulls.line(1));
    assertEquals(4, pulls.line(2));
    assertTrue(pulls.line(3) < 0);
  }

  /** A line of least squares with a prior: -p s v / (1 + p² v). */
  @Test
  void rangesMoveToWhereTheLogIsLikeliest() {
    Leeway leeway = leeway(1, 0, 0);
    Leeway.Pulls pulls = pulls(leeway, posts(0), 0, at(1.05, 1.05), 1, 0);
    double v = AIR + RANGE;
    double[] shifts = leeway.rangeShiftsM(pulls, new double[] {2, 5}, new double[] {-100, -100});

    assertArrayEquals(new double[] {200 * v / (1 + 1e4 * v), 0}, shifts, EXACT);
  }

  /** Half of g² v / (1 + g² v); a reading that can rise by a quarter nat counts half. */
  @Test
  void rangesThatMoveMakeALogLikelier() {
    Leeway leeway = leeway(1, 0, 0);
    double v = AIR + RANGE;

    assertEquals(2500 * v / 2 / (1 + 2500 * v), rangeNats(leeway, 50, 7), 1e-5);
    assertEquals(2500 * v / 2 / (1 + 2500 * v), rangeNats(leeway, 50, 0.5), 1e-5);
    assertEquals(625 * v / 2 / (1 + 1250 * v), rangeNats(leeway, 50, 0.25), 1e-5);
    assertEquals(0, rangeNats(leeway, 0, 7), 0);
    assertEquals(0, leeway.rangeNats(onePing(leeway, 1.05, 0), at(50), at(7)), 0);
  }

  private static double rangeNats(Leeway leeway, double perMetre, double roomNats) {
    return leeway.rangeNats(onePing(leeway, 1.05, 1), at(perMetre), at(roomNats));
  }

  /**
   * With g = 3 and a bend of 1: by 3 v / (1 + v) decibels, which is worth half of 9 v / (1 + v).
   */
  @Test
  void levelsMoveAsFarAsTheyAreOpen() {
    Leeway leeway = leeway(1, 0, 0);
    double v = LEVEL + PLACE;
    Leeway.Moved moved = leeway.moved(onePing(leeway, 1.5, 0), curves(1));
    assertEquals(4.5 * v / (1 + v), moved.nats(), EXACT);
    assertArrayEquals(new double[] {3 * v / (1 + v)}, moved.shiftsDb(), EXACT);

    // Each place is off for itself by the half decibel, not all of them together.
    double off = LEVEL + 0.09;
    Leeway wrong = leeway(1, 0.3, 0);
    assertEquals(
        3 * off / (1 + off), wrong.moved(onePing(wrong, 1.5, 0), curves(1)).shiftsDb()[0], EXACT);
  }

  /** One ping at 1.5 m and one at 1 m: another place, the same day. */
  @Test
  void placesMoveForThemselvesAndTheDayForAll() {
    Leeway leeway = leeway(1, 0, 0);
    Leeway.Pulls two = pulls(leeway, posts(0), 0, at(1.5, 1.5), 0, 0);
    double same = LEVEL + PLACE;
    assertEquals(6 * same / (1 + 2 * same), leeway.moved(two, curves(2)).shiftsDb()[0], EXACT);

    Leeway.Pulls apart = pulls(leeway, posts(0), 0, at(1.5, 1), 0, 0);
    // Covariance of the two shifts: [[a, b], [b, c]]; the move is S (I + S)^-1 (3, 3).
    double a = LEVEL + PLACE;
    double b = LEVEL;
    double c = LEVEL + PLACE + 0.0025;
    double det = (1 + a) * (1 + c) - b * b;
    double x = 3 * (1 + c - b) / det;
    double y = 3 * (1 + a - b) / det;
    assertArrayEquals(
        new double[] {a * x + b * y, b * x + c * y},
        leeway.moved(apart, curves(2)).shiftsDb(),
        EXACT);
  }

  @Test
  void whatNoLevelMovesStays() {
    Leeway leeway = leeway(1, 0, 0);
    EchoCurves flat = new EchoCurves(decibels -> new double[] {-0.5});
    Leeway.Moved moved = leeway.moved(onePing(leeway, 1.5, 0), flat);

    assertEquals(0, moved.nats(), 0);
    assertArrayEquals(new double[1], moved.shiftsDb(), 0);
  }

  /** The reading tells as much as 1 beside the prior's 1 / v. */
  @Test
  void whatTheSetupStillCanBeIsLess() {
    Leeway leeway = leeway(1, 0, 0);

    assertEquals(
        -Math.log(1 + LEVEL + PLACE) / 2,
        leeway.logShare(onePing(leeway, 1.5, 0), curves(1)),
        EXACT);
  }

  /** A ping at the first knot of a curve of 0.3 dB: so much more is open. */
  @Test
  void levelsMayWanderBesides() {
    Leeway leeway = leeway(1, 0, 0);
    Along along = Along.of(new Along.Axis(0, 1, 4, false, 0.1), new int[1], at(0));
    double v = LEVEL + PLACE + 0.09;
    Leeway.Wandered found = leeway.wandered(onePing(leeway, 1.5, 0), curves(1), along, 0.3);

    assertEquals(4.5 * v / (1 + v) - Math.log(1 + v) / 2, found.moved().nats(), 1e-5);
    assertEquals(3 * v / (1 + v), found.moved().shiftsDb()[0], 1e-5);
    assertArrayEquals(new double[] {3 * 0.09 / (1 + v), 0, 0, 0}, found.atKnotsDb(), 1e-5);
  }

  /** Between two knots that know nothing of each other: a quarter and three quarters. */
  @Test
  void betweenKnotsBothWander() {
    Leeway leeway = leeway(1, 0, 0);
    Along along = Along.of(new Along.Axis(0, 1, 4, false, 0.05), new int[1], at(1.75));
    double v = LEVEL + PLACE + 0.09 * (0.0625 + 0.5625);
    double[] knots = leeway.wandered(onePing(leeway, 1.5, 0), curves(1), along, 0.3).atKnotsDb();

    assertArrayEquals(
        new double[] {0, 0.25 * 0.27 / (1 + v), 0.75 * 0.27 / (1 + v), 0}, knots, 1e-5);
  }

  @Test
  void whatHasNoPlaceDoesNotWander() {
    Leeway leeway = leeway(1, 0, 0);
    Along along = Along.of(new Along.Axis(0, 1, 4, false, 0.1), new int[1], at(Double.NaN));
    Leeway.Wandered found = leeway.wandered(onePing(leeway, 1.5, 0), curves(1), along, 0.3);

    assertArrayEquals(new double[4], found.atKnotsDb(), 1e-9);
    double v = LEVEL + PLACE;
    assertEquals(3 * v / (1 + v), found.moved().shiftsDb()[0], EXACT);
  }
}
