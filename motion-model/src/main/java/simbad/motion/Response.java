package simbad.motion;

import simbad.sonar.check.Checks;

/**
 * How speeds follow what is commanded. Neutral figures follow at once.
 *
 * @param speedTimeConstantS of the speed; at least 0
 * @param turnTimeConstantS of the rate of turning; at least 0
 * @param brakingFactor by which time constants are multiplied where the speed falls; above 0
 * @param maxAccelerationMPerS2 above 0, infinite for none
 * @param maxTurnAccelerationRadPerS2 above 0, infinite for none
 * @param brakesToTurnBack whether what turns back is braking until it rests, instead of speeding up
 *     if it will be at least as fast
 * @param rimBaseM 0, or where each wheel's rim follows by itself, with the figures of the speed:
 *     the distance of the wheels, metres
 */
public record Response(
    double speedTimeConstantS,
    double turnTimeConstantS,
    double brakingFactor,
    double maxAccelerationMPerS2,
    double maxTurnAccelerationRadPerS2,
    boolean brakesToTurnBack,
    double rimBaseM) {
  /** Speeds are at once what is commanded. */
  public static final Response AT_ONCE =
      new Response(0, 0, 1, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, false, 0);

  /** Checks the figures. */
  public Response {
    Checks.notNegative("speedTimeConstantS", speedTimeConstantS);
    Checks.notNegative("turnTimeConstantS", turnTimeConstantS);
    Checks.positive("brakingFactor", brakingFactor);
    Checks.positiveOrInfinite("maxAccelerationMPerS2", maxAccelerationMPerS2);
    Checks.positiveOrInfinite("maxTurnAccelerationRadPerS2", maxTurnAccelerationRadPerS2);
    Checks.notNegative("rimBaseM", rimBaseM);
  }

  /**
   * Returns how speeds follow within steps of one length, its exponentials computed once.
   *
   * @param stepS above 0
   */
  public Step over(double stepS) {
    Rate speed = rate(speedTimeConstantS, maxAccelerationMPerS2, stepS);
    Rate turn = rate(turnTimeConstantS, maxTurnAccelerationRadPerS2, stepS);
    return new Step(speed, rimBaseM > 0 ? speed : turn, rimBaseM);
  }

  private Rate rate(double constantS, double most, double stepS) {
    double share = share(stepS, constantS);
    double falls = share(stepS, constantS * brakingFactor);
    return new Rate(
        share,
        constantS > 0 ? share * constantS / stepS : 0,
        falls,
        constantS > 0 ? falls * constantS * brakingFactor / stepS : 0,
        most * stepS,
        brakesToTurnBack);
  }

  private static double share(double stepS, double constantS) {
    return constantS > 0 ? -Math.expm1(-stepS / constantS) : 1;
  }

  /**
   * How speeds follow within steps of one length.
   *
   * @param speed of the speed, or of the left rim
   * @param turn of the rate of turning, or of the right rim
   * @param rimBaseM 0, or the distance of the wheels where each rim follows by itself
   */
  public record Step(Rate speed, Rate turn, double rimBaseM) {
    /** Checks the distance. */
    public Step {
      Checks.notNegative("rimBaseM", rimBaseM);
    }

    /** Puts the means of each step in the place of targets, from rest. */
    void follow(double[] speeds, double[] turns) {
      if (rimBaseM > 0) {
        for (int i = 0; i < speeds.length; i++) {
          double half = turns[i] * rimBaseM / 2;
          turns[i] = speeds[i] + half;
          speeds[i] -= half;
        }
      }
      speed.follow(speeds);
      turn.follow(turns);
      if (rimBaseM > 0) {
        for (int i = 0; i < speeds.length; i++) {
          double left = speeds[i];
          speeds[i] = Unicycle.speedOfWheels(left, turns[i]);
          turns[i] = Unicycle.turnOfWheels(left, turns[i], rimBaseM);
        }
      }
    }
  }

  /**
   * How a rate follows its target within a step.
   *
   * @param share of the difference that is gone after the step where it grows
   * @param kept of the difference, the mean over the step, where it grows
   * @param brakingShare of the difference that is gone where it falls
   * @param brakingKept the mean where it falls
   * @param most by which it changes in a step
   * @param brakesToTurnBack whether it falls where it turns back, however fast it will be
   */
  public record Rate(
      double share,
      double kept,
      double brakingShare,
      double brakingKept,
      double most,
      boolean brakesToTurnBack) {
    /** Checks that all are numbers. */
    public Rate {
      Checks.number("share", share);
      Checks.number("kept", kept);
      Checks.number("brakingShare", brakingShare);
      Checks.number("brakingKept", brakingKept);
      Checks.number("most", most);
    }

    /**
     * Puts the mean rate of each step in the place of its target, from rest.
     *
     * @param targets that hold through each step, the first of no step
     */
    void follow(double[] targets) {
      if (most == Double.POSITIVE_INFINITY) {
        followFreely(targets);
        return;
      }
      double now = 0;
      for (int i = 1; i < targets.length; i++) {
        double next = next(now, targets[i]);
        targets[i] = mean(now, targets[i], next);
        now = next;
      }
    }

    /** The same without a greatest change: exponentials alone, or at once. */
    private void followFreely(double[] targets) {
      double now = 0;
      for (int i = 1; i < targets.length && share < 1; i++) {
        double target = targets[i];
        double off = now - target;
        boolean falls = falls(now, target);
        targets[i] = target + off * (falls ? brakingKept : kept);
        now -= off * (falls ? brakingShare : share);
      }
    }

    private boolean falls(double now, double target) {
      return Math.abs(target) < Math.abs(now) || (brakesToTurnBack && target * now < 0);
    }

    /** Returns the rate after a step towards a target. */
    public double next(double now, double target) {
      double part = falls(now, target) ? brakingShare : share;
      double wanted = part < 1 ? now + (target - now) * part : target;
      return Math.abs(wanted - now) <= most ? wanted : now + Math.copySign(most, wanted - now);
    }

    /**
     * Returns the mean rate of the step.
     *
     * @param now at its start
     * @param target that holds through it
     * @param next at its end
     */
    public double mean(double now, double target, double next) {
      double left = falls(now, target) ? brakingKept : kept;
      if (left > 0 && Math.abs(next - now) < most) {
        return target + (now - target) * left;
      }
      // A ramp up to the end, or up to the target and level from there.
      double by = next - now;
      return by == 0 || next != target ? now + by / 2 : next - by * Math.abs(by) / (2 * most);
    }
  }
}
