package simbad.figures.report;

import java.util.Optional;
import simbad.experiments.run.SensorKind;
import simbad.figures.plot.SeriesRole;

/** What a sensor's curve stands for in every picture. */
public final class SensorRoles {
  private SensorRoles() {}

  /** Returns the role of a sensor: one of its own, or {@link SeriesRole#OTHER}. */
  public static SeriesRole of(SensorKind sensor) {
    return usual(sensor.word()).orElse(SeriesRole.OTHER);
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
