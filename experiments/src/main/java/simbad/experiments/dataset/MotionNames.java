package simbad.experiments.dataset;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simbad.sonar.format.DataFormatException;

/** Names by which columns of commands and tracks often go, as they are or with a unit behind. */
final class MotionNames {
  /** A unit behind a name, and whether it is a rate: yaw_deg, omega [rad/s], v(cm/s). */
  private static final Pattern UNIT =
      Pattern.compile("[\\s_.\\[(]+(\\p{L}+|\u00b0)([\\s_/]*s)?[\\])]*");

  private static final Map<String, List<String>> NAMES =
      Map.ofEntries(
          Map.entry("time", List.of("t_s", "t", "time", "time_s", "t_ms", "time_ms", "stamp")),
          Map.entry("speed", List.of("v_m_s", "v", "speed", "linear", "vx", "v_cm_s", "v_mm_s")),
          Map.entry(
              "turn", List.of("w_rad_s", "w", "omega", "angular", "wz", "yaw_rate", "w_deg_s")),
          Map.entry("left", List.of("left_m_s", "left", "vl", "v_left")),
          Map.entry("right", List.of("right_m_s", "right", "vr", "v_right")),
          Map.entry("x", List.of("x_m", "x", "x_mm", "x_cm")),
          Map.entry("y", List.of("y_m", "y", "y_mm", "y_cm")),
          Map.entry("z", List.of("z_m", "z", "z_mm", "z_cm")),
          Map.entry(
              "heading", List.of("heading_deg", "heading", "yaw", "theta", "phi", "heading_rad")),
          Map.entry("run", List.of("run")));

  private static final Map<String, Unit.Kind> KINDS =
      Map.of(
          "time", Unit.Kind.TIME,
          "speed", Unit.Kind.LENGTH,
          "turn", Unit.Kind.ANGLE,
          "left", Unit.Kind.LENGTH,
          "right", Unit.Kind.LENGTH,
          "x", Unit.Kind.LENGTH,
          "y", Unit.Kind.LENGTH,
          "z", Unit.Kind.LENGTH,
          "heading", Unit.Kind.ANGLE);

  private static final List<String> RATES = List.of("speed", "turn", "left", "right");

  private MotionNames() {}

  /**
   * Finds the column for an option by its name.
   *
   * @param log the table
   * @param option such as heading
   * @throws DataFormatException if several have one of the names
   */
  static OptionalInt find(LogTable log, String option) throws DataFormatException {
    List<String> known = NAMES.getOrDefault(option, List.of());
    for (String name : known) {
      OptionalInt found = LogColumns.find(log, name);
      if (found.isPresent()) {
        return found;
      }
    }
    for (String name : known) {
      for (int column = 0; column < log.names().size(); column++) {
        if (isWithUnit(log.names().get(column).strip(), name, option)) {
          return OptionalInt.of(column);
        }
      }
    }
    return OptionalInt.empty();
  }

  private static boolean isWithUnit(String column, String name, String option) {
    if (!column.toLowerCase(Locale.ROOT).startsWith(name)) {
      return false;
    }
    Matcher unit = UNIT.matcher(column.substring(name.length()));
    return unit.matches()
        && (unit.group(2) != null) == RATES.contains(option)
        && Unit.find(unit.group(1)).map(Unit::kind).equals(Optional.ofNullable(KINDS.get(option)));
  }
}
