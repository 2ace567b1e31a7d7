package simbad.figures.diagnosis;

import java.util.stream.Collectors;
import simbad.figures.page.Numbers;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;

/** Places of the gap in words. */
final class PlaceWords {
  private PlaceWords() {}

  /** All conditions of a place, such as: bearing 10 to 20°, run a. */
  static String words(Place place) {
    return place.conditions().isEmpty()
        ? "everywhere"
        : place.conditions().stream().map(PlaceWords::words).collect(Collectors.joining(", "));
  }

  private static String words(Place.Condition condition) {
    String variable = condition.variable();
    String what =
        switch (variable) {
          case "bearing_deg" -> "bearing";
          case "distance_m" -> "distance";
          case "off_axis_deg" -> "off-axis angle";
          case "t_s" -> "time";
          case "speed_m_s" -> "speed";
          default -> variable;
        };
    String unit = unit(variable);
    return what
        + " "
        + condition.name().orElse("")
        + condition.interval().map(ends -> interval(ends, unit)).orElse("");
  }

  private static String interval(Interval ends, String unit) {
    if (!Double.isFinite(ends.low())) {
      return "below " + Numbers.number(ends.high()) + unit;
    }
    return Double.isFinite(ends.high())
        ? Numbers.number(ends.low()) + " to " + Numbers.number(ends.high()) + unit
        : "from " + Numbers.number(ends.low()) + unit;
  }

  /** The unit that a name ends in, as one writes it behind a number. */
  static String unit(String name) {
    if (name.endsWith("_per_m_s")) {
      return "\u00a0per\u00a0m/s";
    } else if (name.endsWith("_per_rad_s")) {
      return "\u00a0per\u00a0rad/s";
    } else if (name.endsWith("_m_s")) {
      return "\u00a0m/s";
    } else if (name.endsWith("_rad_s")) {
      return "\u00a0rad/s";
    } else if (name.endsWith("_deg_s")) {
      return "\u00a0°/s";
    } else if (name.endsWith("_per_m")) {
      return "\u00a01/m";
    } else if (name.endsWith("_deg")) {
      return "°";
    } else if (name.endsWith("_m")) {
      return "\u00a0m";
    } else if (name.endsWith("_pings") || name.equals("pings")) {
      return "\u00a0pings";
    }
    return name.endsWith("_s") ? "\u00a0s" : "";
  }
}
