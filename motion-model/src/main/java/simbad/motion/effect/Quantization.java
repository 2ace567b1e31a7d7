package simbad.motion.effect;

import java.util.List;
import simbad.motion.CommandUse;

/** Speeds come in steps: the nearest is driven. A step of 0 is none. */
final class Quantization {
  /** Values that are tried: finer steps than a twentieth of the greatest command hardly show. */
  private static final double FACTOR = 0.95;

  private static final int TRIES = 68;

  /** A whole step stays one, however it was rounded. */
  private static final double WHOLE = 1e-9;

  private static final MotionParameter SPEED =
      MotionParameter.smooth("step_m_s", 0, 2, 0, 0.02).inSteps();

  static final MotionForm FORM =
      new MotionForm(
          "command-quantization",
          "command-quantization",
          List.of(
              SPEED.tried(use -> CommandUse.falling(use.speeds(), FACTOR, TRIES)),
              MotionParameter.smooth("step_rad_s", 0, 6, 0, 0.05)
                  .inSteps()
                  .tried(use -> CommandUse.falling(use.turns(), FACTOR, TRIES))),
          p -> new CommandChange(v -> nearest(v, p[0]), w -> nearest(w, p[1])),
          "round commanded speeds to steps of %s m/s",
          false);

  /** The next step towards rest is driven: what is left over is cut off. */
  static final MotionForm CUT =
      new MotionForm(
          "command-quantization",
          "command-quantization: cut",
          FORM.parameters(),
          p -> new CommandChange(v -> cut(v, p[0]), w -> cut(w, p[1])),
          "cut commanded speeds down to steps of %s m/s",
          false);

  private Quantization() {}

  /** Of each wheel by itself. */
  static MotionForm wheels(double wheelBaseM) {
    return new MotionForm(
        "command-quantization",
        "command-quantization: wheels",
        List.of(SPEED.tried(use -> CommandUse.falling(use.rims(), FACTOR, TRIES))),
        p -> new RimChange(wheelBaseM, rim -> nearest(rim, p[0])),
        "round speeds of a wheel to steps of %s m/s",
        false);
  }

  private static double nearest(double command, double step) {
    return step > 0 ? Math.rint(command / step) * step : command;
  }

  private static double cut(double command, double step) {
    return step > 0
        ? Math.copySign(Math.floor(Math.abs(command) / step + WHOLE) * step, command)
        : command;
  }
}
