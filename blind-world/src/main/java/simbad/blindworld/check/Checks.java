package simbad.blindworld.check;

import java.util.List;
import java.util.Optional;

/**
 * Checks of what something is made of. Each returns the value that it was given, and refuses any
 * other, NaN above all, with an {@link IllegalArgumentException} that says its name, its value and
 * what is expected.
 */
public final class Checks {

  private Checks() {}

  /** A number, which may be infinite. */
  public static double number(String name, double value) {
    return checked(!Double.isNaN(value), name, value, "a number");
  }

  /** Numbers, which may be infinite. */
  public static double[] numbers(String name, double... values) {
    for (double value : values) {
      number(name, value);
    }
    return values;
  }

  /** Numbers, which may be infinite; a copy. */
  public static List<Double> numbers(String name, List<Double> values) {
    values.forEach(value -> number(name, value));
    return List.copyOf(values);
  }

  /** A number, if there is one; it may be infinite. */
  public static Optional<Double> number(String name, Optional<Double> value) {
    value.ifPresent(present -> number(name, present));
    return value;
  }

  /** A finite number. */
  public static double finite(String name, double value) {
    return checked(Double.isFinite(value), name, value, "a finite number");
  }

  /** Above 0, and finite. */
  public static double positive(String name, double value) {
    return checked(
        value > 0 && value < Double.POSITIVE_INFINITY, name, value, "a finite number above 0");
  }

  /** At least 0, and finite. */
  public static double notNegative(String name, double value) {
    return checked(
        value >= 0 && value < Double.POSITIVE_INFINITY, name, value, "a finite number from 0 on");
  }

  /** Above 0; infinite stands for no limit. */
  public static double limit(String name, double value) {
    return checked(value > 0, name, value, "above 0");
  }

  /** In [0, 1]. */
  public static double share(String name, double value) {
    return checked(value >= 0 && value <= 1, name, value, "in [0, 1]");
  }

  private static double checked(boolean holds, String name, double value, String expected) {
    if (holds) {
      return value;
    }
    throw new IllegalArgumentException(name + ": " + value + ", expected " + expected);
  }
}
