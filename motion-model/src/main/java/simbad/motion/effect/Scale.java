package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;

/** Translations and rotations that are too long or too short by a factor. */
record Scale(double speedFactor, double turnFactor) implements MotionChange {
  static final MotionForm SPEED =
      new MotionForm(
          "speed-scale",
          "speed-scale",
          List.of(MotionParameter.smooth("speed_factor", 0.2, 5, 1, 0.01)),
          p -> new Scale(p[0], 1),
          "multiply commanded speeds by %s before driving the model",
          false);
  static final MotionForm TURN =
      new MotionForm(
          "turn-scale",
          "turn-scale",
          List.of(MotionParameter.smooth("turn_factor", 0.2, 5, 1, 0.01)),
          p -> new Scale(1, p[0]),
          "multiply commanded turn rates by %s before driving the model",
          false);
  static final MotionForm WHEELS =
      new MotionForm(
          "wheel-scale",
          "wheel-scale",
          List.of(MotionParameter.smooth("wheel_factor", 0.2, 5, 1, 0.01)),
          p -> new Scale(p[0], p[0]),
          "multiply the wheel radius by %s",
          false);

  @Override
  public double speed(double speedMPerS) {
    return speedMPerS * speedFactor;
  }

  @Override
  public double turn(double turnRadPerS, double speedMPerS) {
    return turnRadPerS * turnFactor;
  }
}
