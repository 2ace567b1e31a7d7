package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;

/**
 * Translations and rotations that are too long or too short by a factor, which may grow with them.
 */
record Scale(double speedFactor, double perMPerS, double turnFactor, double perRadPerS)
    implements MotionChange {
  static final MotionForm SPEED =
      new MotionForm(
          "speed-scale",
          "speed-scale",
          List.of(MotionParameter.smooth("speed_factor", 0.2, 5, 1, 0.01)),
          p -> new Scale(p[0], 0, 1, 0),
          "multiply commanded speeds by %s before driving the model",
          false);
  static final MotionForm TURN =
      new MotionForm(
          "turn-scale",
          "turn-scale",
          List.of(MotionParameter.smooth("turn_factor", 0.2, 5, 1, 0.01)),
          p -> new Scale(1, 0, p[0], 0),
          "multiply commanded turn rates by %s before driving the model",
          false);
  static final MotionForm WHEELS =
      new MotionForm(
          "wheel-scale",
          "wheel-scale",
          List.of(MotionParameter.smooth("wheel_factor", 0.2, 5, 1, 0.01)),
          p -> new Scale(p[0], 0, p[0], 0),
          "multiply the wheel radius by %s",
          false);

  /** A motor whose speed does not grow as its command does. */
  static final MotionForm SPEED_GROWING =
      new MotionForm(
          "speed-scale",
          "speed-scale: growing with the speed",
          List.of(
              MotionParameter.smooth("speed_factor", 0.2, 5, 1, 0.01),
              MotionParameter.smooth("speed_factor_per_m_s", -5, 5, 0, 0.05)),
          p -> new Scale(p[0], p[1], 1, 0),
          "multiply commanded speeds by %s; the factor changes with the speed",
          false);

  static final MotionForm TURN_GROWING =
      new MotionForm(
          "turn-scale",
          "turn-scale: growing with the turn rate",
          List.of(
              MotionParameter.smooth("turn_factor", 0.2, 5, 1, 0.01),
              MotionParameter.smooth("turn_factor_per_rad_s", -2, 2, 0, 0.02)),
          p -> new Scale(1, 0, p[0], p[1]),
          "multiply commanded turn rates by %s; the factor changes with the rate",
          false);

  @Override
  public double speed(double speedMPerS, double turnRadPerS) {
    return scaled(speedMPerS, speedFactor, perMPerS);
  }

  @Override
  public double turn(double turnRadPerS, double speedMPerS) {
    return scaled(turnRadPerS, turnFactor, perRadPerS);
  }

  private static double scaled(double value, double factor, double per) {
    return value * Math.max(0, factor + per * Math.abs(value));
  }
}
