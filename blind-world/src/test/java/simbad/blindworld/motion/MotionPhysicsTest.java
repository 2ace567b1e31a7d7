package simbad.blindworld.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Pose;

/** The world's physics against closed forms. */
class MotionPhysicsTest {

  private static final double FOR_S = 8;
  private static final MotionWorld.Seeing SHARP = new MotionWorld.Seeing(Robot.Scatter.NONE, 0);

  private static Robot robot(Robot.Beliefs beliefs) {
    return new Robot(0.03, 0.2, true, beliefs, Robot.Scatter.NONE, false);
  }

  /** Told from 0 on, seen 20 times a second. */
  private static Outing outing(double v, double w) {
    double[] frames =
        IntStream.rangeClosed(0, (int) (20 * FOR_S)).mapToDouble(i -> i / 20.0).toArray();
    Commands commands = new Commands(new double[] {0}, new double[] {v}, new double[] {w});
    return new Outing(
        List.of(new Outing.Run("r", commands, frames, FOR_S, new Pose(1, 2, Math.PI / 2))));
  }

  private static double[] window(Track track, Outing outing, double atS, double horizonS) {
    Windows windows = Windows.of(outing);
    double[][] all = windows.displacements(track);
    for (int i = 0; i < windows.size(); i++) {
      if (windows.at(i).beginS() == atS && windows.at(i).horizonS() == horizonS) {
        return all[i];
      }
    }
    throw new AssertionError("no window at " + atS);
  }

  private static double[] window(List<MotionChange> changes, Outing outing, double atS, double h) {
    MotionWorld world = new MotionWorld(robot(Robot.Beliefs.NONE), SHARP, changes);
    return window(world.drive(outing, 1), outing, atS, h);
  }

  /** A heading of 90 degrees points up the page, against z. */
  @Test
  void straight_goesAlongTheHeading() {
    Outing outing = outing(0.3, 0);
    Track track = MotionWorld.nominal(robot(Robot.Beliefs.NONE)).drive(outing, 1);
    assertEquals(1, track.xM(0, 100), 1e-9);
    assertEquals(2 - 0.3 * 5, track.zM(0, 100), 1e-9);
  }

  /**
   * The chord of an arc of angle a and length s: s sin(a)/a along, s (1 - cos(a))/a to the left.
   */
  @Test
  void arc_hasItsChord() {
    double v = 0.4;
    double w = 0.7;
    double[] moved = window(List.of(), outing(v, w), 1, 5);
    assertEquals(v / w * Math.sin(5 * w), moved[0], 1e-9);
    assertEquals(v / w * (1 - Math.cos(5 * w)), moved[1], 1e-9);
    assertEquals(Math.toDegrees(5 * w), moved[2], 1e-9);
  }

  /** After a step of v a lag of T has cost the way v T (1 - exp(-t/T)). */
  @Test
  void lag_hasItsStepResponse() {
    double v = 0.5;
    double constant = 0.4;
    for (double h : new double[] {0.5, 2, 5}) {
      double[] moved = window(List.of(Lag.firstOrder(constant, 0.1)), outing(v, 0), 0, h);
      assertEquals(v * (h - constant * (1 - Math.exp(-h / constant))), moved[0], 2e-4 * v);
    }
  }

  /** From rest to v at an acceleration a takes v/a, in which half of the way is made. */
  @Test
  void greatestAcceleration_costsHalfOfTheTimeThatItTakes() {
    double v = 0.5;
    double a = 0.25;
    MotionChange change = Lag.approaching(Lag.limited(a), Lag.limited(a));
    assertEquals(v * 5 - v * v / a / 2, window(List.of(change), outing(v, 0), 0, 5)[0], 1e-6);
    assertEquals(a * 0.25 / 2, window(List.of(change), outing(v, 0), 0, 0.5)[0], 1e-6);
  }

  /** Late by 0.137 s is the way of 0.137 s less, whether it is believed or not. */
  @Test
  void latency_isAShift() {
    double[] moved = window(List.of(MotionChange.latency(0.137)), outing(0.5, 0.3), 0, 2);
    assertEquals(Math.toDegrees(0.3 * (2 - 0.137)), moved[2], 1e-9);
    Robot.Beliefs beliefs = new Robot.Beliefs(0.137, 0, 9, 9);
    Outing outing = outing(0.5, 0.3);
    Track track = MotionWorld.nominal(robot(beliefs)).drive(outing, 1);
    assertEquals(moved[0], window(track, outing, 0, 2)[0], 1e-12);
  }

  @Test
  void beliefs_limitSpeedsAndMakeThemLag() {
    Robot.Beliefs limited = new Robot.Beliefs(0, 0, 0.2, 0.1);
    Outing outing = outing(0.5, 0.3);
    double[] moved = window(MotionWorld.nominal(robot(limited)).drive(outing, 1), outing, 0, 2);
    assertEquals(Math.toDegrees(0.2), moved[2], 1e-9);
    Robot.Beliefs lagging = new Robot.Beliefs(0, 0.4, 9, 9);
    double[] late = window(MotionWorld.nominal(robot(lagging)).drive(outing, 1), outing, 0, 2);
    assertEquals(window(List.of(Lag.firstOrder(0.4, 0.4)), outing, 0, 2)[2], late[2], 1e-12);
  }

  /** What is told between steps counts by its share of a step. */
  @Test
  void commandBetweenSteps_loosesNothing() {
    Commands commands =
        new Commands(new double[] {0.0033, 0.5071}, new double[] {0.4, 0}, new double[] {0.2, 0});
    double[] frames = {0, 0.5, 1, 2};
    Outing outing =
        new Outing(List.of(new Outing.Run("r", commands, frames, 2, new Pose(0, 0, 0))));
    double[] moved = window(List.of(), outing, 0, 2);
    assertEquals(Math.toDegrees(0.2 * (0.5071 - 0.0033)), moved[2], 1e-9);
  }

  /** A hole takes the windows that begin or end in it. */
  @Test
  void windows_beginAndEndWhereTheTrackIsKnown() {
    Commands none = new Commands(new double[0], new double[0], new double[0]);
    double[] frames = {4, 4.5, 5.015, 6, 6.521};
    Outing outing = new Outing(List.of(new Outing.Run("r", none, frames, 7, new Pose(0, 0, 0))));
    Windows windows = Windows.of(outing);
    assertEquals(3, windows.size());
    assertEquals(4.0, windows.at(0).beginS());
    assertEquals(0.5, windows.at(0).horizonS());
    assertEquals(2.0, windows.at(1).horizonS());
    assertEquals(4.5, windows.at(2).beginS());
    assertEquals(2, windows.at(2).to());
  }

  /** Of a point forecast twice the mean pinball loss is the distance. */
  @Test
  void loss_ofAPoint_isTheDistance() {
    double[] point = new double[MotionForecast.LEVELS];
    java.util.Arrays.fill(point, 2);
    MotionForecast forecast = new MotionForecast(new double[][][] {{point, point, point}});
    assertEquals(3, forecast.loss(0, 0, 5), 1e-12);
    assertEquals(0, forecast.loss(0, 1, 2), 1e-12);
  }

  /** The continuous ranked probability score of a standard normal at its middle is 0.2337. */
  @Test
  void forecast_ofATracker_hasTheScoreOfItsScatter() {
    MotionWorld world =
        new MotionWorld(
            robot(Robot.Beliefs.NONE),
            new MotionWorld.Seeing(new Robot.Scatter(0.01, 0), 0),
            List.of());
    Outing outing = outing(0, 0);
    MotionForecast forecast = MotionForecast.of(world, outing, 40_000, 7);
    double sd = 0.01 * Math.sqrt(2);
    // 40,000 repeats leave the score within 0.6 %, one deviation.
    assertEquals(0.2337 * sd, forecast.loss(0, 0, 0), 0.04 * 0.2337 * sd);
  }

  @Test
  void trackThatIsRead_isUnwrapped() {
    double[][] run = {{0, 0, 0}, {0, 0, 0}, {3, -3, 3.1}};
    Track track = Track.of(List.<double[][]>of(run));
    assertEquals(2 * Math.PI - 3, track.headingRad(0, 1), 1e-12);
    assertEquals(3.1, track.headingRad(0, 2), 1e-12);
  }

  @Test
  void commandsThatFallInTime_areRefused() {
    double[] two = {1, 0.5};
    assertThrows(IllegalArgumentException.class, () -> new Commands(two, two, two));
    assertThrows(IllegalArgumentException.class, () -> new Commands(two, two, new double[1]));
  }

  @Test
  void noise_hangsTogether() {
    Chance random = new Chance(3);
    Wandering wandering = new Wandering(1, random);
    double last = wandering.next();
    double products = 0;
    double squares = 0;
    for (int i = 0; i < 100_000; i++) {
      double next = wandering.next();
      products += last * next;
      squares += next * next;
      last = next;
    }
    assertEquals(Math.exp(-MotionWorld.STEP_S), products / squares, 0.002);
    assertTrue(Math.abs(squares / 100_000 - 1) < 0.2);
  }
}
