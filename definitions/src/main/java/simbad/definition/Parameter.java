package simbad.definition;

import java.util.Arrays;
import java.util.List;

/**
 * A parameter of a form of an effect.
 *
 * @param name with its unit, as in files: {@code offset_m}, {@code turn_deg}
 * @param neutral at which the form is the nominal model; may be infinite
 * @param low least value that makes sense
 * @param high greatest value that makes sense, above low
 * @param tries values from which a search may start, all in [low, high]
 * @param closed whether nothing lies beyond its ends (all pings, a whole turn): a value at an end
 *     is then as good as any; else the ends are those of the search
 */
public record Parameter(
    String name, double neutral, double low, double high, List<Double> tries, boolean closed) {
  /** A value nearer to an end of the search than this share of the interval stands at it. */
  private static final double AT_END = 1e-3;

  private static final double NEAR_LOW = 0.05;

  /** Checks the interval and copies the tries. */
  public Parameter {
    number(name + ": neutral", neutral);
    if (!(low < high)) {
      throw new IllegalArgumentException(name + ": [" + low + ", " + high + "] is not an interval");
    }
    tries = List.copyOf(tries);
    for (double value : tries) {
      if (!(value >= low && value <= high)) {
        throw new IllegalArgumentException(
            name + " = " + value + " is not in [" + low + ", " + high + "]");
      }
    }
  }

  /**
   * Creates one whose ends are those of the search. Tries that lie outside, since they depend on
   * the sensor, are moved to the end; bounds that cross, for a sensor of hardly any range, are
   * parted.
   *
   * @param name with its unit, as in files
   * @param neutral at which the form is the nominal model; may be infinite
   * @param low least value that makes sense
   * @param high greatest value that makes sense
   * @param tries values from which a search may start
   */
  public static Parameter of(
      String name, double neutral, double low, double high, double... tries) {
    double most = number(name + ": high", high) > low ? high : Math.nextUp(low);
    return new Parameter(
        name,
        neutral,
        low,
        most,
        Arrays.stream(tries).map(v -> Math.max(low, Math.min(most, v))).boxed().distinct().toList(),
        false);
  }

  private static double number(String name, double value) {
    if (Double.isNaN(value)) {
      throw new IllegalArgumentException(name + " = " + value + " is not a number");
    }
    return value;
  }

  /** Returns the same with ends beyond which there is nothing. */
  public Parameter asClosed() {
    return new Parameter(name, neutral, low, high, tries, true);
  }

  /** Tells whether it may have a value: a sensible one, or the neutral one. */
  public boolean permits(double value) {
    return (value >= low && value <= high) || value == neutral;
  }

  /**
   * Tells whether a value stands at an end of the search, where a better one may lie beyond. The
   * neutral value is no such end, nor one that is as good as an infinite neutral value. Of an
   * interval of many decades a thousandth is far from its low end: a twentieth of that is near.
   */
  public boolean isAtBound(double value) {
    double near = AT_END * (high - low);
    double nearLow = low > 0 ? Math.min(near, NEAR_LOW * low) : near;
    boolean atLow = value <= low + nearLow && low != neutral && neutral != Double.NEGATIVE_INFINITY;
    boolean atHigh = value >= high - near && high != neutral && neutral != Double.POSITIVE_INFINITY;
    return !closed && (atLow || atHigh);
  }

  /** Returns in words which values it may have. */
  public String domain() {
    boolean inside = neutral >= low && neutral <= high;
    return "in [" + low + ", " + high + "]" + (inside ? "" : " or " + neutral);
  }

  /** Returns the nearest value that makes sense. */
  public double clamp(double value) {
    return Math.max(low, Math.min(high, value));
  }
}
