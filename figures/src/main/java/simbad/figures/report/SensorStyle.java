package simbad.figures.report;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import simbad.experiments.run.RunResult;
import simbad.figures.plot.SeriesRole;

/** How a sensor's curve looks on a page: a class of the style sheet, and who lies over whom. */
final class SensorStyle {
  /** Broad ones first, so that nothing hides under them. */
  private static final List<SeriesRole> ORDER =
      List.of(
          SeriesRole.SHADOW,
          SeriesRole.OTHER,
          SeriesRole.ORIGINAL,
          SeriesRole.OVERLAP,
          SeriesRole.RAY,
          SeriesRole.NOISY,
          SeriesRole.LEVEL);

  private SensorStyle() {}

  static String of(RunResult result) {
    String role = SensorRoles.of(result.sensor()).name().toLowerCase(Locale.ROOT);
    return "trace " + role + (SensorRoles.pattern(result.sensor()) == 0 ? "" : " second");
  }

  /** The results in the order in which they are drawn. */
  static List<RunResult> drawn(List<RunResult> results) {
    return results.stream()
        .sorted(Comparator.comparingInt(one -> ORDER.indexOf(SensorRoles.of(one.sensor()))))
        .toList();
  }
}
