package simbad.motion.effect;

/**
 * A number of a form.
 *
 * @param name with its unit, as in files
 * @param low least value that is allowed
 * @param high greatest value that is allowed
 * @param neutral value at which nothing changes; within the bounds, may be infinite
 * @param practical change that would matter to somebody; above 0
 */
public record MotionParameter(
    String name, double low, double high, double neutral, double practical) {
  /** Checks the bounds. */
  public MotionParameter {
    if (!(low < high && practical > 0)) {
      throw new IllegalArgumentException(
          name + ": bounds [" + low + ", " + high + "], practical " + practical);
    }
  }

  /** Returns the nearest value that is allowed. */
  public double within(double value) {
    return Math.max(low, Math.min(high, value));
  }
}
