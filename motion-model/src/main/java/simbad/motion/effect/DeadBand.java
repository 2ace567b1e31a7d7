package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;

/** Small commands do nothing. */
record DeadBand(double speedMPerS, double turnRadPerS) implements MotionChange {
  static final MotionForm FORM =
      new MotionForm(
          "dead-band",
          "dead-band",
          List.of(
              new MotionParameter("dead_band_m_s", 0, 1, 0, 0.005),
              new MotionParameter("dead_band_rad_s", 0, 3, 0, 0.01)),
          List.of(
              new double[] {0.02, 0},
              new double[] {0.05, 0},
              new double[] {0.1, 0},
              new double[] {0, 0.05},
              new double[] {0, 0.1},
              new double[] {0, 0.25},
              new double[] {0.05, 0.1}),
          p -> new DeadBand(p[0], p[1]),
          "commands below %s m/s do nothing: do not give them",
          false);

  @Override
  public double commandedSpeed(double command) {
    return Math.abs(command) < speedMPerS ? 0 : command;
  }

  @Override
  public double commandedTurn(double command) {
    return Math.abs(command) < turnRadPerS ? 0 : command;
  }
}
