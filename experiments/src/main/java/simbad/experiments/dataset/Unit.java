package simbad.experiments.dataset;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * A unit of a log.
 *
 * @param words that name it, the first one as it is printed
 * @param kind of what it measures
 * @param times by which a number is multiplied for the SI unit, or degrees for an angle
 * @param over by which it is divided: exact where the factor has no end in binary
 */
record Unit(List<String> words, Kind kind, double times, double over) {
  /** What is measured. */
  enum Kind {
    /** In metres. */
    LENGTH,
    /** In seconds; of a range, the time of flight there and back. */
    TIME,
    /** In degrees. */
    ANGLE,
    /** In degrees Celsius. */
    TEMPERATURE
  }

  static final Unit M = of(Kind.LENGTH, 1, 1, "m", "metre", "metres", "meter", "meters");
  static final Unit CM = of(Kind.LENGTH, 1, 100, "cm", "centimetres", "centimeters");
  static final Unit MM = of(Kind.LENGTH, 1, 1000, "mm", "millimetres", "millimeters");
  static final Unit S = of(Kind.TIME, 1, 1, "s", "sec", "seconds");
  static final Unit MS = of(Kind.TIME, 1, 1e3, "ms", "msec", "millis", "milliseconds");
  static final Unit DEG = of(Kind.ANGLE, 1, 1, "deg", "degree", "degrees", "\u00b0");

  static final Unit CELSIUS = of(Kind.TEMPERATURE, 1, 1, "c", "degc", "\u00b0c", "celsius");

  private static final List<Unit> ALL =
      List.of(
          M,
          CM,
          MM,
          of(Kind.LENGTH, 0.0254, 1, "in", "inch", "inches", "\""),
          of(Kind.LENGTH, 0.3048, 1, "ft", "feet", "foot"),
          S,
          MS,
          of(Kind.TIME, 1, 1e6, "us", "\u00b5s", "\u03bcs", "usec", "micros", "microseconds"),
          of(Kind.TIME, 1, 1e9, "ns"),
          of(Kind.TIME, 60, 1, "min"),
          DEG,
          CELSIUS,
          of(Kind.ANGLE, 180 / Math.PI, 1, "rad", "radians"),
          of(Kind.ANGLE, 0.9, 1, "gon", "grad"),
          of(Kind.ANGLE, 360, 1, "turn", "turns"));

  private static final List<String> NO_UNIT_IN_NAMES = List.of("min", "turn", "turns");
  private static final int LONGEST_ABBREVIATION = 4;

  /** No column is called so for anything else. */
  private static final List<String> UNIT_ALONE = List.of("cm", "mm", "us", "ms");

  private static Unit of(Kind kind, double times, double over, String... words) {
    return new Unit(List.of(words), kind, times, over);
  }

  /** Finds a unit by one of its words. */
  static Optional<Unit> find(String word) {
    String small = word.toLowerCase(Locale.ROOT);
    return ALL.stream().filter(unit -> unit.words.contains(small)).findFirst();
  }

  /** Finds the unit that a column's name ends with, as in reading_cm, d [mm], time (us). */
  static Optional<Unit> inName(String column) {
    List<String> words = Arrays.asList(column.strip().split("[^\\p{L}\\d\u00b0\"]+"));
    String last = words.isEmpty() ? "" : words.get(words.size() - 1);
    // A name such as s alone is a name; range_min and target_turn end with no unit.
    boolean isUnit =
        words.size() > 1
            || last.length() > LONGEST_ABBREVIATION
            || UNIT_ALONE.contains(last.toLowerCase(Locale.ROOT));
    return isUnit && !NO_UNIT_IN_NAMES.contains(last.toLowerCase(Locale.ROOT))
        ? find(last)
        : Optional.empty();
  }

  /** Returns the words of a kind's units, for messages. */
  static String words(Kind kind) {
    return ALL.stream()
        .filter(unit -> unit.kind == kind)
        .map(Unit::word)
        .collect(Collectors.joining(", "));
  }

  /** Returns how it is printed. */
  String word() {
    return words.get(0);
  }

  /** Returns a number of these in the SI unit, or degrees. */
  double si(double number) {
    return number * times / over;
  }
}
