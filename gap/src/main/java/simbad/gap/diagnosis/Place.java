package simbad.gap.diagnosis;

import java.util.List;
import java.util.Optional;
import simbad.sonar.check.Checks;

/**
 * A place of the gap: a slice of the rows in which it is larger than elsewhere, found on one half
 * of the blocks and measured on the other.
 *
 * @param conditions what the rows have in common
 * @param rows number of the rows in the confirming half
 * @param shareOfGap their share of the gap, in [0, 1]
 * @param beforeCm mean gap of those rows under the simulator as it is, centimetres
 * @param afterCm the same under the diagnosed model
 * @param kind in what way they part
 * @param qValue significance in the confirming half, corrected for the number of slices looked at
 */
public record Place(
    List<Condition> conditions,
    int rows,
    double shareOfGap,
    double beforeCm,
    double afterCm,
    GapKind kind,
    double qValue) {
  /** Copies the conditions. */
  public Place {
    Checks.number("shareOfGap", shareOfGap);
    Checks.number("beforeCm", beforeCm);
    Checks.number("afterCm", afterCm);
    Checks.number("qValue", qValue);
    conditions = List.copyOf(conditions);
  }

  /**
   * A condition on a row.
   *
   * @param variable name as in files: bearing_deg, distance_m, off_axis_deg, obstacle, sensor, run,
   *     t_s, speed_m_s
   * @param interval of a number, [low, high)
   * @param name of a text
   */
  public record Condition(String variable, Optional<Interval> interval, Optional<String> name) {}
}
