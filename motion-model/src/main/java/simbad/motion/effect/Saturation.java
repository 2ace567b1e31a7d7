package simbad.motion.effect;

import java.util.List;
import simbad.motion.CommandUse;

/** Large commands are cut. */
final class Saturation {
  private static final double NONE = Double.POSITIVE_INFINITY;

  /** Sizes that are tried, each of which was commanded. */
  private static final int TRIES = 6;

  private static final MotionParameter RIM =
      MotionParameter.smooth("max_speed_m_s", 0.01, 20, NONE, 0.01);

  static final MotionForm SPEED =
      new MotionForm(
          "saturation",
          "saturation: speed",
          List.of(RIM.tried(use -> CommandUse.among(use.speeds(), TRIES))),
          p -> new CommandChange(v -> cut(v, p[0]), w -> w),
          "cut speeds at %s m/s",
          false);
  static final MotionForm TURN =
      new MotionForm(
          "saturation",
          "saturation: turning",
          List.of(
              MotionParameter.smooth("max_turn_rad_s", 0.02, 20, NONE, 0.03)
                  .tried(use -> CommandUse.among(use.turns(), TRIES))),
          p -> new CommandChange(v -> v, w -> cut(w, p[0])),
          "cut turn rates at %s rad/s",
          false);

  private Saturation() {}

  /** Of each wheel by itself. */
  static MotionForm wheels(double wheelBaseM) {
    return new MotionForm(
        "saturation",
        "saturation: wheels",
        List.of(RIM.tried(use -> CommandUse.among(use.rims(), TRIES))),
        p -> new RimChange(wheelBaseM, rim -> cut(rim, p[0])),
        "cut speeds of a wheel at %s m/s",
        false);
  }

  private static double cut(double command, double most) {
    return Math.abs(command) > most ? Math.copySign(most, command) : command;
  }
}
