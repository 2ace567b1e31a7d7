package simbad.experiments.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.frame.Angles;
import simbad.sonar.sensing.Readings;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/** The follower in scenes whose edge is known in closed form; no simulator, no obstacle. */
class EdgeFollowerTest {
  private static final double SPEED = 0.02;

  private static EdgeFollower follower(double speed) {
    return new EdgeFollower(Tuning.standard(speed, Course.STEP_S));
  }

  private static Course course(Course.Region region, double x, double z, double headingRad) {
    return new Course(region, follower(SPEED), x, z, headingRad);
  }

  private static Course.Region circle(double radius) {
    return (x, z) -> Math.hypot(x, z) <= radius;
  }

  private static Course.Region inside(ThresholdTable table) {
    return (x, z) -> Math.hypot(x, z) <= table.thresholdM(Angles.positive(Math.atan2(x, z)));
  }

  /** The mean distance from a circle while going round it once on its edge. */
  private static double meanBesideM(Course course, double radius, int mostSteps) {
    double sum = 0;
    int places = 0;
    while (!course.isRound() && course.steps() < mostSteps) {
      course.step();
      if (course.isOnEdge()) {
        sum += Math.abs(Math.hypot(course.x(), course.z()) - radius);
        places++;
      }
    }
    return sum / places;
  }

  /**
   * A circle of 1 m at any speed: it gets round, and weaves by a few steps' length. The way is 6.3
   * m, weaving at 30 degrees and more makes it longer by 1 / cos 60 at most: allow three times.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0.005, 0.01, 0.02, 0.05, 0.1})
  void circle_isFollowedAtAnySpeed(double speed) {
    double step = speed * Course.STEP_S;
    Course course = new Course(circle(1), follower(speed), 0.5, 0, Math.PI);
    double beside = meanBesideM(course, 1, (int) (3 * 7 / step));
    assertTrue(course.isRound(), "round after " + course.steps());
    assertTrue(beside < 4 * step, "beside " + beside + " with steps of " + step);
  }

  /** Starts in the middle of nowhere, looking at the post, and at the post itself. */
  @ParameterizedTest
  @CsvSource({"3, 0, 180", "0, 2, 90", "-4, 0.1, 0", "0.01, 0, 77", "0.99, 0, 0"})
  void start_insideOrOutside_findsTheEdge(double x, double z, double headingDeg) {
    Course course = course(circle(1), x, z, Math.toRadians(headingDeg));
    assertTrue(course.drive(40_000).isRound());
  }

  /** Where nothing is ever heard it drives straight on, for ever. */
  @Test
  void silence_drivesStraightOn() {
    Course course = course((x, z) -> false, 1, 2, 0);
    course.drive(1000);
    assertEquals(1 + 1000 * SPEED * Course.STEP_S, course.x(), 1e-9);
    assertEquals(2, course.z(), 1e-9);
  }

  /** Heard everywhere it drives away from the post, and never finds an edge. */
  @Test
  void heardEverywhere_drivesAway() {
    Course course = course((x, z) -> true, 1, 0, Math.PI);
    course.drive(5000);
    // Away along +x, less the time to turn: half a turn at one turn per second.
    assertTrue(course.x() > 1 + 0.9 * 5000 * SPEED * Course.STEP_S, "x = " + course.x());
  }

  /** Corners of a right angle, sides along the axes. */
  @Test
  void square_isFollowedRoundItsCorners() {
    Course.Region square = (x, z) -> Math.max(Math.abs(x), Math.abs(z)) <= 0.5;
    assertTrue(course(square, 0.2, 0.1, 2).drive(20_000).isRound());
  }

  private static ThresholdTable spiky(Random random) {
    double[] values = new double[72];
    for (int i = 0; i < values.length; i++) {
      values[i] = random.nextInt(4) == 0 ? random.nextDouble(1, 3) : random.nextDouble(0.15, 0.5);
    }
    return ThresholdTable.of(values);
  }

  /** Needles and notches of 5 degrees: never trapped, whatever the table. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12})
  void spikyTable_neverTraps(int seed) {
    ThresholdTable table = spiky(new Random(seed));
    double edge = Outline.of(table.points()).perimeterM();
    Course course = course(inside(table), 0.05, 0.05, seed);
    course.drive((long) (30 * edge / (SPEED * Course.STEP_S)));
    assertTrue(course.isRound(), course.steps() + " steps for an edge of " + edge + " m");
  }

  /** One echo in 200 is missed and none is made up: it still gets round, at every seed. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5})
  void missedEchoes_doNotStopIt(int seed) {
    Random random = new Random(seed);
    Course.Region noisy = (x, z) -> Math.hypot(x, z) <= 1 && random.nextInt(200) > 0;
    assertTrue(course(noisy, 0.5, 0, 1).drive(60_000).isRound());
  }

  /**
   * Soft by 2 cm, as the SRF04's edge is: it cuts across at times, but neither leaves nor stops.
   */
  @Test
  void softEdge_isRounded() {
    Random random = new Random(8);
    Course.Region soft =
        (x, z) -> random.nextDouble() < 1 / (1 + Math.exp((Math.hypot(x, z) - 1) / 0.02));
    Course course = course(soft, 0.5, 0, 1);
    while (!course.isRound() && course.steps() < 200_000) {
      course.step();
      assertTrue(Math.hypot(course.x(), course.z()) < 1.5, "left at step " + course.steps());
    }
    assertTrue(course.isRound());
  }

  /** Equal readings, equal commands: nothing else enters. Ranges do not either, only echoes. */
  @Test
  void commands_dependOnEchoesOnly() {
    EdgeFollower one = follower(SPEED);
    EdgeFollower two = follower(SPEED);
    Random random = new Random(4);
    Command first = new Command();
    Command second = new Command();
    for (int i = 0; i < 5000; i++) {
      boolean heard = i / 40 % 2 == 0;
      one.decide(readings(heard, 0, 0.5), first);
      two.decide(readings(heard, 0, random.nextDouble(0.1, 5)), second);
      assertEquals(first.speedMPerS(), second.speedMPerS(), "step " + i);
      assertEquals(first.turnRateRadPerS(), second.turnRateRadPerS(), "step " + i);
    }
  }

  private static Readings readings(boolean heard, int sonar, double range) {
    Readings readings = new Readings(12);
    if (heard) {
      readings.setEcho(sonar, range);
    }
    return readings;
  }

  /** Neither velocity ever exceeds its bound, whatever is heard. */
  @Test
  void commands_stayWithinTheTuning() {
    EdgeFollower follower = follower(SPEED);
    Random random = new Random(6);
    Command command = new Command();
    for (int i = 0; i < 20_000; i++) {
      follower.decide(readings(random.nextBoolean(), random.nextInt(12), 1), command);
      assertTrue(command.speedMPerS() >= 0 && command.speedMPerS() <= SPEED);
      assertTrue(Math.abs(command.turnRateRadPerS()) <= 2 * Math.PI + 1e-9);
    }
  }

  /** Heard behind, it goes on ahead; heard ahead, it turns on the spot first. */
  @Test
  void firstEcho_turnsTheBackToIt() {
    Command command = new Command();
    follower(SPEED).decide(readings(true, 6, 1), command);
    assertEquals(SPEED, command.speedMPerS());
    assertEquals(0, command.turnRateRadPerS(), 1e-9);
    follower(SPEED).decide(readings(true, 0, 1), command);
    assertEquals(0, command.speedMPerS());
    assertEquals(2 * Math.PI, Math.abs(command.turnRateRadPerS()), 1e-9);
  }

  @Test
  void tuning_refusesWhatIsOutOfRange() {
    for (double bad : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> Tuning.standard(bad, 0.05));
      assertThrows(IllegalArgumentException.class, () -> Tuning.standard(0.01, bad));
      assertThrows(IllegalArgumentException.class, () -> new Tuning(1, 1, bad, 0.5, 1));
      assertThrows(IllegalArgumentException.class, () -> new Tuning(1, 1, 1, bad, 1));
      assertThrows(IllegalArgumentException.class, () -> new Tuning(1, 1, 1, 0.5, bad));
    }
    assertThrows(IllegalArgumentException.class, () -> new Tuning(1, 1, 1, Math.PI / 2, 1));
  }
}
