package simbad.motion.effect;

import java.util.function.Function;
import simbad.motion.CommandUse;
import simbad.sonar.check.Checks;

/**
 * A number of a form.
 *
 * @param name with its unit, as in files
 * @param low least value that is allowed
 * @param high greatest value that is allowed
 * @param neutral value at which nothing changes; within the bounds, may be infinite
 * @param practical change that would matter to somebody; above 0, infinite where it matters only by
 *     what other values make of it
 * @param beside whether it says nothing while the value before it is neutral
 * @param stepped whether motion jumps as the value changes, so that slopes say nothing
 * @param tries values that a fit tries first, by what was commanded
 */
public record MotionParameter(
    String name,
    double low,
    double high,
    double neutral,
    double practical,
    boolean beside,
    boolean stepped,
    Function<CommandUse, double[]> tries) {
  private static final double PROBE = 0.1;

  /** Checks the bounds. */
  public MotionParameter {
    Checks.number(name + ": neutral", neutral);
    if (!(low < high && practical > 0)) {
      throw new IllegalArgumentException(
          name + ": bounds [" + low + ", " + high + "], practical " + practical);
    }
  }

  /**
   * Creates one on which motion depends smoothly.
   *
   * @param name with its unit, as in files
   * @param low least value that is allowed
   * @param high greatest value that is allowed
   * @param neutral value at which nothing changes
   * @param practical change that would matter to somebody
   */
  static MotionParameter smooth(
      String name, double low, double high, double neutral, double practical) {
    return new MotionParameter(
        name, low, high, neutral, practical, false, false, use -> new double[] {neutral});
  }

  /** Returns the same with values that a fit tries, which lie within the bounds. */
  MotionParameter tried(double... values) {
    return tried(use -> values.clone());
  }

  /** Returns the same with values that a fit tries by what was commanded. */
  MotionParameter tried(Function<CommandUse, double[]> values) {
    return new MotionParameter(name, low, high, neutral, practical, beside, stepped, values);
  }

  /** Returns the same, jumping. */
  MotionParameter inSteps() {
    return new MotionParameter(name, low, high, neutral, practical, beside, true, tries);
  }

  /** Returns the same of a value that says nothing while the one before it is neutral. */
  MotionParameter besideTheOneBefore() {
    return new MotionParameter(name, low, high, neutral, practical, true, stepped, tries);
  }

  /** Returns by how much the value is moved to see how motion changes. */
  public double probe() {
    return practical < Double.POSITIVE_INFINITY ? practical / 2 : PROBE * neutral;
  }

  /** Returns the nearest value that is allowed. */
  public double within(double value) {
    return Math.max(low, Math.min(high, value));
  }

  /** Tells whether a value stands at an end beyond which a better one may lie. */
  public boolean isAtBound(double value) {
    boolean atLow = value <= low && low != neutral;
    boolean atHigh = value >= high && high != neutral && neutral != Double.POSITIVE_INFINITY;
    return atLow || atHigh;
  }
}
