package simbad.figures.report;

import java.util.Optional;
import simbad.experiments.run.SensorKind;
import simbad.figures.plot.PolarSeries;
import simbad.figures.plot.SeriesRole;

/** What a sensor's curve stands for in every picture. */
public final class SensorRoles {
  private SensorRoles() {}

  /**
   * Returns the role of a sensor: one of its own, or {@link SeriesRole#OTHER}. On a robot that
   * moves in its own way a sensor keeps its role and is dashed otherwise.
   */
  public static SeriesRole of(SensorKind sensor) {
    return usual(sensor.hearing()).orElse(SeriesRole.OTHER);
  }

  /** Returns the dash of a sensor's curve: that of its role, or the one of moving robots. */
  static int pattern(SensorKind sensor) {
    return sensor.robot().isPresent() ? PolarSeries.SECOND : 0;
  }

  /**
   * Finds the role of a sensor that the program brings.
   *
   * @param word as on the command line
   */
  public static Optional<SeriesRole> usual(String word) {
    return SensorKind.plain().stream()
        .map(SensorKind::word)
        .filter(word::equals)
        .findFirst()
        .map(SensorRoles::role);
  }

  private static SeriesRole role(String word) {
    return switch (word) {
      case "original" -> SeriesRole.ORIGINAL;
      case "ray" -> SeriesRole.RAY;
      case "shadow" -> SeriesRole.SHADOW;
      case "overlap" -> SeriesRole.OVERLAP;
      case "noisy" -> SeriesRole.NOISY;
      case "level" -> SeriesRole.LEVEL;
      default -> SeriesRole.OTHER;
    };
  }
}
