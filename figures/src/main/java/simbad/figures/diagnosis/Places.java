package simbad.figures.diagnosis;

import java.util.stream.Collectors;
import simbad.figures.markup.Markup;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;

/** Places of the gap in words. */
final class Places {
  private Places() {}

  /** All conditions of a place, such as: bearing 10 to 20°, run a. */
  static String words(Place place) {
    return place.conditions().isEmpty()
        ? "everywhere"
        : place.conditions().stream().map(Places::words).collect(Collectors.joining(", "));
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
    return Markup.escaped(what)
        + " "
        + condition.name().map(Markup::escaped).orElse("")
        + condition.interval().map(ends -> interval(ends, unit)).orElse("");
  }

  private static String interval(Interval ends, String unit) {
    if (!Double.isFinite(ends.low())) {
      return "below " + Html.number(ends.high()) + unit;
    }
    return Double.isFinite(ends.high())
        ? Html.number(ends.low()) + " to " + Html.number(ends.high()) + unit
        : "from " + Html.number(ends.low()) + unit;
  }

  /** The unit that a name ends in, as one writes it behind a number. */
  static String unit(String name) {
    if (name.endsWith("_per_m_s")) {
      return "&nbsp;per&nbsp;m/s";
    } else if (name.endsWith("_per_rad_s")) {
      return "&nbsp;per&nbsp;rad/s";
    } else if (name.endsWith("_m_s")) {
      return "&nbsp;m/s";
    } else if (name.endsWith("_rad_s")) {
      return "&nbsp;rad/s";
    } else if (name.endsWith("_deg_s")) {
      return "&nbsp;°/s";
    } else if (name.endsWith("_per_m")) {
      return "&nbsp;1/m";
    } else if (name.endsWith("_deg")) {
      return "°";
    } else if (name.endsWith("_m")) {
      return "&nbsp;m";
    } else if (name.endsWith("_pings") || name.equals("pings")) {
      return "&nbsp;pings";
    }
    return name.endsWith("_s") ? "&nbsp;s" : "";
  }
}
