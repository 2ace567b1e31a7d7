package simbad.blindworld.motionchange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static simbad.blindworld.motionchange.MotionGround.BASE_M;
import static simbad.blindworld.motionchange.MotionGround.effect;
import static simbad.blindworld.motionchange.MotionGround.heard;
import static simbad.blindworld.motionchange.MotionGround.number;

import org.junit.jupiter.api.Test;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.world.FixedChance;

/** Dead-band, saturation, command-quantization: what becomes of what is told. */
class CommandFormsTest {

  private static final double NEAR = 1e-12;

  private static void assertHears(MotionEffect effect, double v, double w, double isV, double isW) {
    Speeds heard = heard(effect, v, w);
    assertEquals(isV, heard.vMPerS(), NEAR, "speed");
    assertEquals(isW, heard.wRadPerS(), NEAR, "turn rate");
  }

  /** 0.3 of the middle ones: 0.09 m/s and 0.18 rad/s. */
  @Test
  void nothingBelow_dropsWhatIsInTheBand() {
    MotionEffect effect = effect("dead-band", "nothing below", 1);
    assertEquals(0.09, number(effect, "m_s"), NEAR);
    assertEquals(0.18, number(effect, "rad_s"), NEAR);
    assertHears(effect, 0.08, 0.17, 0, 0);
    assertHears(effect, -0.08, -0.17, 0, 0);
    assertHears(effect, 0.1, 0.19, 0.1, 0.19);
    assertHears(effect, -0.1, -0.19, -0.1, -0.19);
    double band = number(effect, "m_s");
    assertHears(effect, band, 0, band, 0);
  }

  /** By a third of the band, and never to the other side. */
  @Test
  void lessByIt_takesTheBandAway() {
    MotionEffect effect = effect("dead-band", "less by it", 2);
    assertEquals(0.06, number(effect, "m_s"), NEAR);
    assertEquals(0.12, number(effect, "rad_s"), NEAR);
    assertHears(effect, 0.2, -0.5, 0.14, -0.38);
    assertHears(effect, -0.2, 0.5, -0.14, 0.38);
    assertHears(effect, 0.05, -0.1, 0, 0);
  }

  /** It starts at 0.09 m/s and 0.18 rad/s and stops under 0.06 and 0.12. */
  @Test
  void sticks_untilPushed_andThenGoesOn() {
    double[][] told = {
      {0.08, 0.1}, {0.1, 0.17}, {-0.07, 0.2}, {0.061, 0.13}, {0.05, -0.121}, {0.08, 0.11},
    };
    double[][] expected = {{0, 0}, {0.1, 0}, {-0.07, 0.2}, {0.061, 0.13}, {0, -0.121}, {0, 0}};
    Commands heard =
        heard(
            effect("dead-band", "sticks until pushed", 1),
            new FixedChance(0.5),
            new double[] {0, 1, 2, 3, 4, 5},
            told);
    for (int i = 0; i < told.length; i++) {
      assertEquals(new Speeds(expected[i][0], expected[i][1]), heard.at(i), "command " + i);
    }
  }

  /** The rims of 0.1 m/s and 0.8 rad/s are 0.04 and 0.16 m/s, and the band 0.7 of 0.09. */
  @Test
  void deadWheels_haveABandEach() {
    MotionEffect effect = effect("dead-band", "of each wheel", 1);
    assertEquals(0.063, number(effect, "rim_m_s"), NEAR);
    assertHears(effect, 0.1, 0.8, 0.08, 0.16 / BASE_M);
    assertHears(effect, 0.1, -0.8, 0.08, -0.16 / BASE_M);
  }

  /** A quarter under the greatest ones, which are 0.5 m/s and 1 rad/s; at most down to 0.4. */
  @Test
  void hard_cutsBothSpeeds() {
    MotionEffect effect = effect("saturation", "hard", 1);
    assertEquals(0.375, number(effect, "m_s"), NEAR);
    assertEquals(0.75, number(effect, "rad_s"), NEAR);
    assertHears(effect, 0.5, -1, 0.375, -0.75);
    assertHears(effect, -0.5, 1, -0.375, 0.75);
    assertHears(effect, 0.3, -0.7, 0.3, -0.7);
    assertEquals(0.25, number(effect("saturation", "hard", 2), "m_s"), NEAR);
    assertEquals(0.2, number(effect("saturation", "hard", 9), "m_s"), NEAR);
  }

  /** Straight up to half of the level; above it bends towards the level and never exceeds it. */
  @Test
  void soft_bendsTowardsItsLevel() {
    MotionEffect effect = effect("saturation", "soft", 1);
    double v = 0.5 * 0.75 * 1.15;
    double w = 0.75 * 1.15;
    assertEquals(v, number(effect, "m_s"), NEAR);
    assertEquals(w, number(effect, "rad_s"), NEAR);
    assertHears(effect, 0.2, -0.4, 0.2, -0.4);
    assertHears(effect, v, -w, v / 2 * (1 + Math.tanh(1)), -w / 2 * (1 + Math.tanh(1)));
    assertHears(effect, 99, -99, v, -w);
    assertHears(effect("saturation", "soft", 0), 99, -99, 99, -99);
  }

  @Test
  void ofTheSpeed_leavesTurning() {
    MotionEffect effect = effect("saturation", "of the speed", 1);
    assertEquals(0.375, number(effect, "m_s"), NEAR);
    assertHears(effect, 0.5, 9, 0.375, 9);
    assertHears(effect, -0.5, -9, -0.375, -9);
  }

  /** The fastest rim is 0.5 + 0.6 * 0.075 m/s; without any change 0.5 + 1 * 0.075. */
  @Test
  void ofEachWheel_cutsRims() {
    MotionEffect effect = effect("saturation", "of each wheel", 1);
    double rim = 0.75 * 0.545;
    assertEquals(rim, number(effect, "rim_m_s"), NEAR);
    assertEquals(0.575, number(effect("saturation", "of each wheel", 0), "rim_m_s"), NEAR);
    // Rims of 0.325 and 0.475 m/s.
    assertHears(effect, 0.4, 1, (0.325 + rim) / 2, (rim - 0.325) / BASE_M);
    assertHears(effect, -0.4, 1, -(0.325 + rim) / 2, (rim - 0.325) / BASE_M);
  }

  /** Both slowed by one factor, whichever wheel is too fast, so that speed over turn is kept. */
  @Test
  void keptCurve_slowsBoth() {
    MotionEffect effect = effect("saturation", "the curve is kept", 1);
    double rim = 0.75 * 0.545;
    assertEquals(rim, number(effect, "rim_m_s"), NEAR);
    double factor = rim / 0.475;
    assertHears(effect, 0.4, 1, 0.4 * factor, factor);
    assertHears(effect, 0.4, -1, 0.4 * factor, -factor);
    assertHears(effect, -0.4, 1, -0.4 * factor, factor);
    assertHears(effect, 0.3, 1, 0.3, 1);
  }

  /** 0.35 of 0.5 m/s and of 1 rad/s. */
  @Test
  void rounded_takesTheNearestStep() {
    MotionEffect effect = effect("command-quantization", "rounded", 1);
    assertEquals(0.175, number(effect, "m_s"), NEAR);
    assertEquals(0.35, number(effect, "rad_s"), NEAR);
    assertHears(effect, 0.26, -0.53, 0.175, -0.7);
    assertHears(effect, -0.27, 0.17, -0.35, 0);
    assertHears(effect("command-quantization", "rounded", 0), 0.26, 0.53, 0.26, 0.53);
  }

  @Test
  void cut_takesTheStepTowardsNothing() {
    MotionEffect effect = effect("command-quantization", "cut", 1);
    assertEquals(0.0875, number(effect, "m_s"), NEAR);
    assertEquals(0.175, number(effect, "rad_s"), NEAR);
    assertHears(effect, 0.17, -0.34, 0.0875, -0.175);
    assertHears(effect, -0.17, 0.34, -0.0875, 0.175);
    // A whole number of steps is kept.
    assertHears(effect, 3 * 0.0875, 0.175, 3 * 0.0875, 0.175);
    assertHears(effect("command-quantization", "cut", 0), 0.17, 0.34, 0.17, 0.34);
  }

  /** Steps of 0.14 m/s; the rims of 0.2 m/s and 1 rad/s are 0.125 and 0.275 m/s. */
  @Test
  void wheelSteps_roundRims() {
    MotionEffect effect = effect("command-quantization", "of each wheel", 1);
    assertEquals(0.14, number(effect, "rim_m_s"), NEAR);
    assertHears(effect, 0.2, 1, 0.21, 0.14 / BASE_M);
  }

  /** What is not heard keeps the command before; before the first it stands. */
  @Test
  void dropped_keepsTheOneBefore() {
    MotionEffect effect = effect("dropped-commands", "by chance", 1);
    assertEquals(0.35, number(effect, "share"), NEAR);
    assertEquals(0.8, number(effect("dropped-commands", "by chance", 9), "share"), NEAR);
    assertEquals(Stage.COMMAND, effect.change().stage());
    Commands heard =
        heard(
            effect,
            new FixedChance(0.34, 0.36, 0.1, 0.9),
            new double[] {0, 1, 2, 3},
            new double[][] {{1, 2}, {3, 4}, {5, 6}, {7, 8}});
    assertEquals(new Speeds(0, 0), heard.at(0));
    assertEquals(new Speeds(3, 4), heard.at(1));
    assertEquals(new Speeds(3, 4), heard.at(2));
    assertEquals(new Speeds(7, 8), heard.at(3));
  }
}
