package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;

/** Speeds come in steps: the nearest is driven. A step of 0 is none. */
record Quantization(double speedStepMPerS, double turnStepRadPerS) implements MotionChange {
  static final MotionForm FORM =
      new MotionForm(
          "command-quantization",
          "command-quantization",
          List.of(
              new MotionParameter("step_m_s", 0, 1, 0, 0.01),
              new MotionParameter("step_rad_s", 0, 3, 0, 0.02)),
          List.of(
              new double[] {0.02, 0},
              new double[] {0.05, 0},
              new double[] {0.1, 0},
              new double[] {0, 0.1},
              new double[] {0, 0.25},
              new double[] {0.05, 0.25}),
          p -> new Quantization(p[0], p[1]),
          "round commanded speeds to steps of %s m/s",
          false);

  @Override
  public double commandedSpeed(double command) {
    return nearest(command, speedStepMPerS);
  }

  @Override
  public double commandedTurn(double command) {
    return nearest(command, turnStepRadPerS);
  }

  private static double nearest(double command, double step) {
    return step > 0 ? Math.rint(command / step) * step : command;
  }
}
