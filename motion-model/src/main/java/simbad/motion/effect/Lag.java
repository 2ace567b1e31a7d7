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
      MotionParameter.smooth("speed_time_constant_s", 0, 3, 0, 0.03).tried(0.05, 0.15, 0.4);
  private static final MotionParameter TURN =
      MotionParameter.smooth("turn_time_constant_s", 0, 3, 0, 0.03).tried(0.05, 0.15, 0.4);

  static final MotionForm CONSTANTS =
      new MotionForm(
          "actuation-lag",
          "actuation-lag: time constants",
          List.of(SPEED, TURN),
          p -> new Lag(p[0], p[1], 1, NO_LIMIT, NO_LIMIT),
          "let the speed follow commands with a time constant of %s s",
          false);
  static final MotionForm BRAKING =
      new MotionForm(
          "actuation-lag",
          "actuation-lag: other in braking",
          List.of(
              SPEED,
              TURN,
              MotionParameter.smooth("braking_factor", 0.05, 20, 1, NO_LIMIT).tried(0.4, 1, 2.5)),
          p -> new Lag(p[0], p[1], p[2], NO_LIMIT, NO_LIMIT),
          "let the speed follow commands with a time constant of %s s, and with a "
              + "different one while braking",
          false);
  static final MotionForm ACCELERATION =
      new MotionForm(
          "actuation-lag",
          "actuation-lag: greatest acceleration",
          List.of(
              MotionParameter.smooth("acceleration_m_s2", 0.01, 100, NO_LIMIT, 0.02)
                  .tried(2, 1, 0.5, 0.25, 0.1),
              MotionParameter.smooth("turn_acceleration_rad_s2", 0.05, 1000, NO_LIMIT, 0.1)
                  .tried(10, 5, 2.5, 1, 0.5)),
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
