package simbad.sonar.check;

import java.util.List;
import java.util.OptionalDouble;

/**
 * Checks of arguments. Each returns the value that it was given, and refuses any other, NaN above
 * all, with its name, its value and what is permitted.
 */
public final class Checks {
  private Checks() {}

  /**
   * Checks that a value is a finite number.
   *
   * @throws IllegalArgumentException for NaN and the infinities
   */
  public static double finite(String name, double value) {
    if (Double.isFinite(value)) {
      return value;
    }
    throw new IllegalArgumentException(name + " = " + value + " is not finite");
  }

  /**
   * Checks that a value, if there is one, is a finite number.
   *
   * @throws IllegalArgumentException for NaN and the infinities
   */
  public static OptionalDouble finite(String name, OptionalDouble value) {
    value.ifPresent(present -> finite(name, present));
    return value;
  }

  /**
   * Checks that a value is a number, be it infinite.
   *
   * @throws IllegalArgumentException for NaN
   */
  public static double number(String name, double value) {
    if (Double.isNaN(value)) {
      throw new IllegalArgumentException(name + " = NaN is not a number");
    }
    return value;
  }

  /**
   * Checks that all values are numbers, be they infinite.
   *
   * @return the same array
   * @throws IllegalArgumentException if one is NaN; its place stands behind the name
   */
  public static double[] numbers(String name, double... values) {
    for (int i = 0; i < values.length; i++) {
      if (Double.isNaN(values[i])) {
        throw new IllegalArgumentException(name + "[" + i + "] = NaN is not a number");
      }
    }
    return values;
  }

  /**
   * Checks that all values are numbers, be they infinite.
   *
   * @return the same rows
   * @throws IllegalArgumentException if one is NaN; its place in its row stands behind the name
   */
  public static double[][] numbers(String name, double[][] rows) {
    for (double[] row : rows) {
      numbers(name, row);
    }
    return rows;
  }

  /**
   * Checks that all values are numbers, be they infinite.
   *
   * @return the same list
   * @throws IllegalArgumentException if one is NaN; its place stands behind the name
   */
  public static List<Double> numbers(String name, List<Double> values) {
    numbers(name, values.stream().mapToDouble(Double::doubleValue).toArray());
    return values;
  }

  /**
   * Checks that a value, if there is one, is a number, be it infinite.
   *
   * @throws IllegalArgumentException for NaN
   */
  public static OptionalDouble number(String name, OptionalDouble value) {
    value.ifPresent(present -> number(name, present));
    return value;
  }

  /**
   * Checks that a value is in [0, infinity).
   *
   * @throws IllegalArgumentException for any other, NaN among them
   */
  public static double notNegative(String name, double value) {
    return checked(value >= 0 && value < Double.POSITIVE_INFINITY, name, value, "[0, infinity)");
  }

  /**
   * Checks that a value is in (0, infinity).
   *
   * @throws IllegalArgumentException for any other, NaN among them
   */
  public static double positive(String name, double value) {
    return checked(value > 0 && value < Double.POSITIVE_INFINITY, name, value, "(0, infinity)");
  }

  /**
   * Checks that a value is in (0, infinity], where no bound is a bound as well.
   *
   * @throws IllegalArgumentException for any other, NaN among them
   */
  public static double positiveOrInfinite(String name, double value) {
    return checked(value > 0, name, value, "(0, infinity]");
  }

  /**
   * Checks that a value is in [0, infinity], where no bound is a bound as well.
   *
   * @throws IllegalArgumentException for any other, NaN among them
   */
  public static double notNegativeOrInfinite(String name, double value) {
    return checked(value >= 0, name, value, "[0, infinity]");
  }

  /**
   * Checks that a value is a share, in [0, 1].
   *
   * @throws IllegalArgumentException for any other, NaN among them
   */
  public static double share(String name, double value) {
    return within(name, value, 0, 1);
  }

  /**
   * Checks that a value is in [least, greatest].
   *
   * @throws IllegalArgumentException for any other, NaN among them
   */
  public static double within(String name, double value, double least, double greatest) {
    boolean inside = value >= least && value <= greatest;
    return inside
        ? value
        : checked(false, name, value, "[" + text(least) + ", " + text(greatest) + "]");
  }

  /**
   * Checks that a value is in [least, infinity).
   *
   * @throws IllegalArgumentException for any other, NaN among them
   */
  public static double atLeast(String name, double value, double least) {
    boolean inside = value >= least && value < Double.POSITIVE_INFINITY;
    return inside ? value : checked(false, name, value, "[" + text(least) + ", infinity)");
  }

  /**
   * Checks that a value is in (low, infinity).
   *
   * @throws IllegalArgumentException for any other, NaN among them
   */
  public static double above(String name, double value, double low) {
    boolean inside = value > low && value < Double.POSITIVE_INFINITY;
    return inside ? value : checked(false, name, value, "(" + text(low) + ", infinity)");
  }

  private static double checked(boolean holds, String name, double value, String permitted) {
    if (holds) {
      return value;
    }
    throw new IllegalArgumentException(name + " = " + value + " is not in " + permitted);
  }

  private static String text(double bound) {
    return bound == Math.rint(bound) && Math.abs(bound) < Integer.MAX_VALUE
        ? String.valueOf((long) bound)
        : String.valueOf(bound);
  }
}
