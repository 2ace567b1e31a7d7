package simbad.blindworld.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.world.Chance;

/** How speeds approach what is told, and the kinds of changes. A step is 0.02 s. */
class LagTest {

  private static final double NEAR = 1e-12;
  private static final Chance RANDOM = new Chance(1);
  private static final Commands TOLD =
      new Commands(new double[] {0, 1}, new double[] {0.2, 0.4}, new double[] {1, 2});

  /** Of the 2 that are missing exp(-0.02 / 0.1) is left after a step. */
  @Test
  void exponential_leavesItsShareOfWhatIsMissing() {
    assertEquals(3 - 2 * Math.exp(-0.2), Lag.exponential(0.1).next(1, 3), NEAR);
    assertEquals(3, Lag.exponential(0).next(1, 3));
  }

  /** 2 per second are 0.04 in a step. */
  @Test
  void limited_goesNoFasterThanItsLimit() {
    Lag.Approach limited = Lag.limited(2);
    assertEquals(0.04, limited.next(0, 1), NEAR);
    assertEquals(0.96, limited.next(1, -5), NEAR);
    assertEquals(1.03, limited.next(1, 1.03));
    assertEquals(0.97, limited.next(1, 0.97));
    assertEquals(9, Lag.limited(Double.POSITIVE_INFINITY).next(0, 9));
  }

  @ParameterizedTest
  @CsvSource({
    "1, 2, 1",
    "-1, -2, 1",
    "0, 1, 1",
    "0, -1, 1",
    "1, 1, 1",
    "2, 1, -1",
    "-2, -1, -1",
    "1, 0, -1",
    "1, -2, -1",
    "-1, 2, -1",
  })
  void unequal_tellsGrowingFromBraking(double from, double to, double rule) {
    assertEquals(rule, Lag.unequal((f, t) -> 1, (f, t) -> -1).next(from, to));
  }

  private static void move(Acting acting, Step step, double v, double w) {
    AnyStep.next(step, v, w);
    acting.move(step);
  }

  /** By 0.1 m/s and 0.05 rad/s in a step: on the way the mean of a step's ends counts. */
  @Test
  void approaching_countsTheMeanUntilItHasArrived() {
    MotionChange change = Lag.approaching(Lag.limited(5), Lag.limited(2.5));
    assertEquals(Stage.ACTUATION, change.stage());
    Acting acting = change.begin().apply(RANDOM);
    acting.beginRun();
    Step step = new Step(1);
    move(acting, step, 0.25, -0.05);
    assertEquals(0.05, step.v(), NEAR);
    assertEquals(-0.05, step.w(), NEAR);
    move(acting, step, 0.25, -0.15);
    assertEquals(0.15, step.v(), NEAR);
    assertEquals(-0.075, step.w(), NEAR);
    move(acting, step, 0.25, -0.15);
    assertEquals(0.25, step.v(), NEAR, "it has arrived");
    assertEquals(-0.15, step.w(), NEAR);
    acting.beginRun();
    move(acting, step, 0.25, 0.2);
    assertEquals(0.05, step.v(), NEAR, "a run begins at rest");
    assertEquals(0.025, step.w(), NEAR);
  }

  @Test
  void firstOrder_hasAConstantForEachSpeed() {
    Acting acting = Lag.firstOrder(0.1, 0.4).begin().apply(RANDOM);
    Step step = new Step(1);
    move(acting, step, 1, 1);
    assertEquals((1 - Math.exp(-0.2)) / 2, step.v(), NEAR);
    assertEquals((1 - Math.exp(-0.05)) / 2, step.w(), NEAR);
  }

  @Test
  void changeOfCommands_leavesStepsAndFrames() {
    MotionChange change = MotionChange.commands(s -> new Speeds(2 * s.vMPerS(), 3 * s.wRadPerS()));
    assertEquals(Stage.COMMAND, change.stage());
    assertEquals(new Speeds(0.8, 6), change.heard().apply(TOLD, RANDOM).at(1));
    Acting acting = change.begin().apply(RANDOM);
    Step step = AnyStep.told(0.4, 0.5);
    Sight sight = AnyStep.seen(1, 2, 3);
    acting.beginRun();
    acting.move(step);
    acting.see(sight);
    assertEquals(0.4, step.v());
    assertEquals(1, sight.xM());
    assertEquals(0, acting.agoS(5, 0.5));
  }

  @Test
  void changeOfStepsOrFrames_leavesCommands() {
    MotionChange steps = MotionChange.steps(Stage.TURNING, step -> step.addTurn(1));
    assertEquals(Stage.TURNING, steps.stage());
    assertSame(TOLD, steps.heard().apply(TOLD, RANDOM));
    Step step = AnyStep.told(0.4, 0.5);
    steps.begin().apply(RANDOM).move(step);
    assertEquals(1.5, step.w());
    MotionChange frames = MotionChange.frames(sight -> sight.turn(1));
    assertEquals(Stage.TRACK, frames.stage());
    assertSame(TOLD, frames.heard().apply(TOLD, RANDOM));
    Sight sight = AnyStep.seen(1, 2, 3);
    frames.begin().apply(RANDOM).see(sight);
    assertEquals(4, sight.headingRad());
  }

  @Test
  void latency_makesAllCommandsLate() {
    MotionChange late = MotionChange.latency(0.3);
    assertEquals(Stage.TIME, late.stage());
    assertEquals(1.3, late.heard().apply(TOLD, RANDOM).timeS(1), NEAR);
    assertThrows(IllegalArgumentException.class, () -> MotionChange.latency(Double.NaN));
  }
}
