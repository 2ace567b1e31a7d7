package simbad.figures.plot;

import java.util.List;
import java.util.function.Function;

/** Checks of arguments, written so that NaN fails. */
final class Checks {
  private Checks() {}

  static void finite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(name + " = " + value + " is not finite");
    }
  }

  static void notNegative(String name, double value) {
    if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(name + " = " + value + " is not in [0, infinity)");
    }
  }

  static void positive(String name, double value) {
    if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(name + " = " + value + " is not in (0, infinity)");
    }
  }

  static void notBlank(String name, String value) {
    if (value.isBlank()) {
      throw new IllegalArgumentException(name + " is blank");
    }
  }

  /** A legend with the same name twice says nothing. */
  static <T> void distinctNames(List<T> series, Function<T, String> nameOf) {
    List<String> names = series.stream().map(nameOf).toList();
    if (names.stream().distinct().count() != names.size()) {
      throw new IllegalArgumentException("series names are not distinct: " + names);
    }
  }
}
