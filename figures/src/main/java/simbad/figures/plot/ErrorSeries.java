package simbad.figures.plot;

import java.util.Comparator;
import java.util.List;

/**
 * The radial errors of one sensor's trace.
 *
 * @param name what the legend says; not blank
 * @param role which sensor, which fixes its looks
 * @param pattern 0 for the role's own dash, or {@link PolarSeries#SECOND}
 * @param errors at the table's bearings, in any order; a bearing that the trace never crossed is
 *     left out and shows as a gap; may be empty
 */
public record ErrorSeries(String name, SeriesRole role, int pattern, List<BearingError> errors) {
  /** Copies the list, in the order of the bearings. */
  public ErrorSeries {
    Labels.notBlank("name", name);
    errors = errors.stream().sorted(Comparator.comparingDouble(BearingError::bearingDeg)).toList();
  }

  /** Creates a series with its role's own dash. */
  public ErrorSeries(String name, SeriesRole role, List<BearingError> errors) {
    this(name, role, 0, errors);
  }
}
