package simbad.figures.plot;

import java.util.List;
import java.util.function.Function;

/** Checks of the words in a picture. */
final class Labels {
  private Labels() {}

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
