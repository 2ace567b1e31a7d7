package simbad.blindworld.motionchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static simbad.blindworld.motionchange.MotionGround.BASE_M;
import static simbad.blindworld.motionchange.MotionGround.WHEEL_M;
import static simbad.blindworld.motionchange.MotionGround.effect;
import static simbad.blindworld.motionchange.MotionGround.moved;
import static simbad.blindworld.motionchange.MotionGround.number;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.motion.AnyStep;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.Step;
import simbad.blindworld.world.FixedChance;

/** Speed-scale, turn-scale, wheel-scale, wheel-asymmetry, turn-bias: what wheels make of speeds. */
class ScaleFormsTest {

  private static final double NEAR = 1e-12;
  private static final double ROUND_M = 2 * Math.PI * WHEEL_M;

  private static void assertMoves(MotionEffect effect, Step step, double v, double w) {
    Step moved = moved(effect, step);
    assertEquals(v, moved.v(), NEAR, "speed");
    assertEquals(w, moved.w(), NEAR, "turn rate");
  }

  @ParameterizedTest
  @CsvSource({
    "speed-scale, factor, 0.06", "speed-scale, with a ripple, 0.06",
    "speed-scale, more when fast, 0.06", "turn-scale, factor, 0.07",
    "turn-scale, more when turning fast, 0.07", "wheel-scale, factor, 0.06",
    "wheel-scale, out of round, 0.06",
  })
  void factor_isLongerOrShorterByItsSize(String name, String form, double share) {
    MotionEffect longer = effect(name, form, 1);
    assertEquals(1 + share, number(longer, "factor"), NEAR);
    assertEquals(Stage.WHEEL, longer.change().stage());
    MotionEffect shorter = effect(name, form, 2, new FixedChance(0.5).coins(false));
    assertEquals(1 / (1 + 2 * share), number(shorter, "factor"), NEAR);
  }

  @Test
  void factors_areOfSpeedOrTurnOrBoth() {
    assertMoves(effect("speed-scale", "factor", 1), AnyStep.told(0.2, 0.5), 0.212, 0.5);
    assertMoves(effect("turn-scale", "factor", 1), AnyStep.told(0.2, 0.5), 0.2, 0.535);
    assertMoves(effect("wheel-scale", "factor", 1), AnyStep.told(0.2, 0.5), 0.212, 0.53);
  }

  /** 4/3 of what is too much at the begin of a wheel's turn, 2/3 half a turn later. */
  @Test
  void ripple_goesRoundWithTheWheel() {
    MotionEffect speed = effect("speed-scale", "with a ripple", 1);
    MotionEffect both = effect("wheel-scale", "out of round", 1);
    double[][] shares = {{0, 4 / 3.0}, {0.25, 1}, {0.5, 2 / 3.0}, {1, 4 / 3.0}};
    for (double[] share : shares) {
      double factor = 1 + 0.06 * share[1];
      double wayM = share[0] * ROUND_M;
      assertMoves(speed, AnyStep.after(wayM, 0.2, 0.5), 0.2 * factor, 0.5);
      assertMoves(both, AnyStep.after(wayM, 0.2, 0.5), 0.2 * factor, 0.5 * factor);
    }
  }

  /** The greatest speed is 0.5 m/s: 0.7 of it at rest, 1 at the half, 1.3 from the greatest on. */
  @Test
  void speedScale_isMoreWhenFast() {
    MotionEffect effect = effect("speed-scale", "more when fast", 1);
    assertMoves(effect, AnyStep.told(0.25, 0.5), 0.25 * 1.06, 0.5);
    assertMoves(effect, AnyStep.told(-0.25, 0.5), -0.25 * 1.06, 0.5);
    assertMoves(effect, AnyStep.told(0.5, 0.5), 0.5 * 1.078, 0.5);
    assertMoves(effect, AnyStep.told(2, 0.5), 2 * 1.078, 0.5);
  }

  /** The greatest turn rate is 1 rad/s: 0.8 of it at rest, 1 at the half, 1.2 from there on. */
  @Test
  void turnScale_isMoreWhenTurningFast() {
    MotionEffect effect = effect("turn-scale", "more when turning fast", 1);
    assertMoves(effect, AnyStep.told(0.2, 0.5), 0.2, 0.5 * 1.07);
    assertMoves(effect, AnyStep.told(0.2, -0.5), 0.2, -0.5 * 1.07);
    assertMoves(effect, AnyStep.told(0.2, 1), 0.2, 1.084);
    assertMoves(effect, AnyStep.told(0.2, 3), 0.2, 3 * 1.084);
  }

  @Test
  void wheelBase_thatIsShorter_turnsMore() {
    MotionEffect effect = effect("turn-scale", "wheel base", 1);
    assertEquals(BASE_M / 1.07, number(effect, "base_m"), NEAR);
    assertMoves(effect, AnyStep.told(0.2, 0.5), 0.2, 0.5 * 1.07);
  }

  /** A turn of 0.08 rad in a metre: on this base wheels that differ by 0.012 of their size. */
  @Test
  void radii_turnARobotThatIsToldToGoStraight() {
    MotionEffect effect = effect("wheel-asymmetry", "radii", 1);
    assertEquals(1.012, number(effect, "right_over_left"), NEAR);
    assertMoves(effect, AnyStep.told(0.5, 0), 0.5, 0.08 * 0.5);
    // Turning on the spot the rims go -0.075 and 0.075 m/s.
    assertMoves(effect, AnyStep.told(0, 1), 0.075 * 0.006, 1);
    MotionEffect left = effect("wheel-asymmetry", "radii", 2, new FixedChance(0.5).coins(false));
    assertEquals(0.976, number(left, "right_over_left"), NEAR);
  }

  @Test
  void curvature_isByTheWay() {
    MotionEffect effect = effect("wheel-asymmetry", "curvature", 1);
    assertEquals(0.08, number(effect, "rad_m"), NEAR);
    assertMoves(effect, AnyStep.told(0.5, 0.3), 0.5, 0.34);
    assertMoves(effect, AnyStep.told(-0.5, 0.3), -0.5, 0.26);
  }

  /** Only the right wheel, and with a spot: 4/3 of the 0.012 first and 2/3 half a turn later. */
  @Test
  void softTyre_isOfTheRightWheel() {
    MotionEffect effect = effect("wheel-asymmetry", "a soft tyre", 1);
    assertEquals(1.012, number(effect, "right_over_left"), NEAR);
    assertMoves(effect, AnyStep.told(0.5, 0), 0.5 + 0.5 * 0.016 / 2, 0.5 * 0.016 / BASE_M);
    assertMoves(
        effect, AnyStep.after(ROUND_M / 2, 0.5, 0), 0.5 + 0.5 * 0.008 / 2, 0.5 * 0.008 / BASE_M);
  }

  @Test
  void bias_turnsAlwaysOrOnlyWhileItDrives() {
    MotionEffect always = effect("turn-bias", "always", 1);
    assertEquals(0.02, number(always, "rad_s"), NEAR);
    assertEquals(Stage.TURNING, always.change().stage());
    assertMoves(always, AnyStep.told(0, 0), 0, 0.02);
    assertMoves(always, AnyStep.told(0.3, 0.5), 0.3, 0.52);
    MotionEffect driving = effect("turn-bias", "while it drives", 2);
    assertMoves(driving, AnyStep.told(0, 0), 0, 0);
    assertMoves(driving, AnyStep.told(0.3, 0), 0.3, 0.04);
    assertMoves(driving, AnyStep.told(0, -0.5), 0, -0.46);
  }

  /** From 0.95 of it at the log's begin to 1.05 at its end. */
  @Test
  void gyro_warmsUpOverTheLog() {
    MotionEffect effect = effect("turn-bias", "a gyro that is held", 1);
    assertMoves(effect, AnyStep.told(0, 0.5, 0), 0, 0.5 + 0.02 * 0.95);
    assertMoves(effect, AnyStep.told(0, 0.5, 0.5), 0, 0.52);
    assertMoves(effect, AnyStep.told(0, 0.5, 1), 0, 0.5 + 0.02 * 1.05);
  }
}
