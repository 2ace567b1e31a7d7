package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;

/** Turning that nobody commanded: at a constant rate, or in proportion to the speed. */
record Veer(double biasRadPerS, double perMetreRad) implements MotionChange {
  private static final MotionParameter TURN =
      MotionParameter.smooth("turn_rad_per_m", -5, 5, 0, 0.02);

  static final MotionForm BIAS =
      new MotionForm(
          "turn-bias",
          "turn-bias",
          List.of(MotionParameter.smooth("bias_rad_s", -1, 1, 0, 0.002)),
          p -> new Veer(p[0], 0),
          "add %s rad/s to every turn rate",
          false);
  static final MotionForm ASYMMETRY =
      new MotionForm(
          "wheel-asymmetry",
          "wheel-asymmetry",
          List.of(TURN),
          p -> new Veer(0, p[0]),
          "add %s rad per metre driven to every turn",
          false);

  /** One wheel alone is off: the right one on a base above 0, the left one on a base below. */
  static final MotionForm ONE_WHEEL =
      new MotionForm(
          "wheel-asymmetry",
          "wheel-asymmetry: one wheel",
          List.of(
              TURN,
              MotionParameter.smooth("signed_base_m", -2, 2, 0.2, Double.POSITIVE_INFINITY)
                  .besideTheOneBefore()
                  .tried(-0.4, -0.15, 0.15, 0.4)),
          p -> new OneWheel(p[0], p[1]),
          "make one wheel larger or smaller: alone it adds %s rad per metre driven to every turn",
          false);

  /** Adding nothing must not make -0 of 0. */
  @Override
  public double turn(double turnRadPerS, double speedMPerS) {
    double extra = biasRadPerS + perMetreRad * speedMPerS;
    return extra == 0 ? turnRadPerS : turnRadPerS + extra;
  }
}
