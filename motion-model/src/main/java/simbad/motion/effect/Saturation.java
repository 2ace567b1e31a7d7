package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;

/** Large commands are cut. */
record Saturation(double speedMPerS, double turnRadPerS) implements MotionChange {
  private static final double NONE = Double.POSITIVE_INFINITY;

  static final MotionForm SPEED =
      new MotionForm(
          "saturation",
          "saturation: speed",
          List.of(new MotionParameter("max_speed_m_s", 0.01, 20, NONE, 0.01)),
          List.of(new double[] {0.08}, new double[] {0.15}, new double[] {0.3}, new double[] {0.6}),
          p -> new Saturation(p[0], NONE),
          "cut speeds at %s m/s",
          false);
  static final MotionForm TURN =
      new MotionForm(
          "saturation",
          "saturation: turning",
          List.of(new MotionParameter("max_turn_rad_s", 0.02, 20, NONE, 0.02)),
          List.of(new double[] {0.2}, new double[] {0.4}, new double[] {0.8}, new double[] {1.6}),
          p -> new Saturation(NONE, p[0]),
          "cut turn rates at %s rad/s",
          false);

  @Override
  public double commandedSpeed(double command) {
    return Math.abs(command) > speedMPerS ? Math.copySign(speedMPerS, command) : command;
  }

  @Override
  public double commandedTurn(double command) {
    return Math.abs(command) > turnRadPerS ? Math.copySign(turnRadPerS, command) : command;
  }
}
