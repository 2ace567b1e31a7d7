package simbad.figures.diagnosis;

import java.util.stream.Collectors;
import simbad.figures.page.Numbers;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.motion.MotionPlace;

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
    return what(variable)
        + " "
        + condition.name().orElse("")
        + condition.interval().map(ends -> interval(variable, ends)).orElse("");
  }

  /** A place of a drive, such as: turn rate 0.5 to 1 rad/s, run a. */
  static String words(MotionPlace place) {
    return what(place.axis())
        + " "
        + (place.name().isEmpty()
            ? interval(place.axis(), new Interval(place.low(), place.high()))
            : place.name());
  }

  /** The page of the studio has the same words (words-of-gap.js). */
  private static String what(String variable) {
    return switch (variable) {
      case "bearing_deg" -> "bearing";
      case "distance_m" -> "distance";
      case "off_axis_deg" -> "off-axis angle";
      case "t_s" -> "time";
      case "speed_m_s" -> "speed";
      case "turn_rad_s" -> "turn rate";
      case "since_change_s" -> "since the last change";
      case "speed_change_m_s" -> "change of speed";
      case "heading_deg" -> "heading";
      case "x_m" -> "x";
      case "z_m" -> "z";
      default -> variable;
    };
  }

  private static String interval(String variable, Interval ends) {
    String unit = unit(variable);
    if (!Double.isFinite(ends.low())) {
      return "below " + end(variable, ends.high()) + unit;
    }
    return Double.isFinite(ends.high())
        ? end(variable, ends.low()) + " to " + end(variable, ends.high()) + unit
        : "from " + end(variable, ends.low()) + unit;
  }

  /** Clocks that count from 1970 need all their digits. */
  private static String end(String variable, double value) {
    return variable.equals("t_s")
        ? Numbers.fixed(value, 1).replaceFirst("\\.0$", "")
        : Numbers.number(value);
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
