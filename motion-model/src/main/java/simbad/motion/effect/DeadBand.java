package simbad.motion.effect;

import java.util.List;
import simbad.motion.CommandUse;

/** Small commands do nothing. */
final class DeadBand {
  /** Values that are tried, each between two sizes that were commanded. */
  private static final int TRIES = 24;

  private static final MotionParameter SPEED =
      MotionParameter.smooth("dead_band_m_s", 0, 1, 0, 0.01).inSteps();

  static final MotionForm FORM =
      new MotionForm(
          "dead-band",
          "dead-band",
          List.of(
              SPEED.tried(use -> CommandUse.between(use.speeds(), TRIES)),
              MotionParameter.smooth("dead_band_rad_s", 0, 3, 0, 0.03)
                  .inSteps()
                  .tried(use -> CommandUse.between(use.turns(), TRIES))),
          p -> new CommandChange(v -> cut(v, p[0]), w -> cut(w, p[1])),
          "commands below %s m/s do nothing: do not use them",
          false);

  /** What friction takes away is missing from larger commands, too. */
  static final MotionForm LESS =
      new MotionForm(
          "dead-band",
          "dead-band: less by it",
          List.of(
              MotionParameter.smooth("dead_band_m_s", 0, 1, 0, 0.01).tried(0.01, 0.05),
              MotionParameter.smooth("dead_band_rad_s", 0, 3, 0, 0.03).tried(0.03, 0.1)),
          p -> new CommandChange(v -> less(v, p[0]), w -> less(w, p[1])),
          "every speed is %s m/s too low: command that much more",
          false);

  private DeadBand() {}

  /** Of each wheel by itself. */
  static MotionForm wheels(double wheelBaseM) {
    return new MotionForm(
        "dead-band",
        "dead-band: wheels",
        List.of(SPEED.tried(use -> CommandUse.between(use.rims(), TRIES))),
        p -> new RimChange(wheelBaseM, rim -> cut(rim, p[0])),
        "wheel speeds below %s m/s do nothing: do not use them",
        false);
  }

  private static double cut(double command, double band) {
    return Math.abs(command) < band ? 0 : command;
  }

  private static double less(double command, double band) {
    return Math.copySign(Math.max(0, Math.abs(command) - band), command);
  }
}
