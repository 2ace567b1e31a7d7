package simbad.motion.effect;

import java.util.List;
import simbad.motion.MotionChange;
import simbad.motion.Response;

/** Speeds that approach the command gradually, beside what was believed already. */
record Lag(
    double speedS, double turnS, double brakingFactor, double acceleration, double turnAcceleration)
    implements MotionChange {
  private static final double NO_LIMIT = Double.POSITIVE_INFINITY;
  private static final MotionParameter SPEED =
      new MotionParameter("speed_time_constant_s", 0, 3, 0, 0.01);
  private static final MotionParameter TURN =
      new MotionParameter("turn_time_constant_s", 0, 3, 0, 0.01);

  static final MotionForm CONSTANTS =
      new MotionForm(
          "actuation-lag",
          "actuation-lag: time constants",
          List.of(SPEED, TURN),
          List.of(new double[] {0.1, 0.1}, new double[] {0.4, 0.4}),
          p -> new Lag(p[0], p[1], 1, NO_LIMIT, NO_LIMIT),
          "let the speed follow commands with a time constant of %s s",
          false);
  static final MotionForm BRAKING =
      new MotionForm(
          "actuation-lag",
          "actuation-lag: other in braking",
          List.of(SPEED, TURN, new MotionParameter("braking_factor", 0.05, 20, 1, 0.1)),
          List.of(new double[] {0.2, 0.2, 1}),
          p -> new Lag(p[0], p[1], p[2], NO_LIMIT, NO_LIMIT),
          "let the speed follow commands with a time constant of %s s, another in braking",
          false);
  static final MotionForm ACCELERATION =
      new MotionForm(
          "actuation-lag",
          "actuation-lag: greatest acceleration",
          List.of(
              new MotionParameter("acceleration_m_s2", 0.01, 100, NO_LIMIT, 0.01),
              new MotionParameter("turn_acceleration_rad_s2", 0.05, 1000, NO_LIMIT, 0.05)),
          List.of(new double[] {0.3, 1.5}, new double[] {1.5, 8}),
          p -> new Lag(0, 0, 1, p[0], p[1]),
          "limit accelerations to %s m/s2",
          false);

  @Override
  public Response response(Response before) {
    return new Response(
        before.speedTimeConstantS() + speedS,
        before.turnTimeConstantS() + turnS,
        before.brakingFactor() * brakingFactor,
        Math.min(before.maxAccelerationMPerS2(), acceleration),
        Math.min(before.maxTurnAccelerationRadPerS2(), turnAcceleration));
  }
}
