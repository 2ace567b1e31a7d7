package simbad.motion;

/**
 * How speeds follow what is commanded. Neutral figures follow at once.
 *
 * @param speedTimeConstantS of the speed; at least 0
 * @param turnTimeConstantS of the rate of turning; at least 0
 * @param brakingFactor by which time constants are multiplied where the speed falls; above 0
 * @param maxAccelerationMPerS2 above 0, infinite for none
 * @param maxTurnAccelerationRadPerS2 above 0, infinite for none
 */
public record Response(
    double speedTimeConstantS,
    double turnTimeConstantS,
    double brakingFactor,
    double maxAccelerationMPerS2,
    double maxTurnAccelerationRadPerS2) {
  /** Speeds are at once what is commanded. */
  public static final Response AT_ONCE =
      new Response(0, 0, 1, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);

  /** Checks the figures. */
  public Response {
    if (!(speedTimeConstantS >= 0 && turnTimeConstantS >= 0 && brakingFactor > 0)) {
      throw new IllegalArgumentException(
          "time constants = "
              + speedTimeConstantS
              + ", "
              + turnTimeConstantS
              + " s, braking "
              + brakingFactor
              + ": expected at least 0 s and a factor above 0");
    }
    if (!(maxAccelerationMPerS2 > 0 && maxTurnAccelerationRadPerS2 > 0)) {
      throw new IllegalArgumentException(
          "accelerations = "
              + maxAccelerationMPerS2
              + ", "
              + maxTurnAccelerationRadPerS2
              + " are not above 0");
    }
  }

  /** Returns the speed after a step towards a target. */
  public double speed(double now, double target, double stepS) {
    return follow(now, target, stepS, speedTimeConstantS, maxAccelerationMPerS2);
  }

  /** Returns the rate of turning after a step towards a target. */
  public double turn(double now, double target, double stepS) {
    return follow(now, target, stepS, turnTimeConstantS, maxTurnAccelerationRadPerS2);
  }

  private double follow(double now, double target, double stepS, double constantS, double most) {
    double constant = Math.abs(target) < Math.abs(now) ? constantS * brakingFactor : constantS;
    double wanted = constant > 0 ? now + (target - now) * -Math.expm1(-stepS / constant) : target;
    double limit = most * stepS;
    return Math.abs(wanted - now) <= limit ? wanted : now + Math.copySign(limit, wanted - now);
  }
}
