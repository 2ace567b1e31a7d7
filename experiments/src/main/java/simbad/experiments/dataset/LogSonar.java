package simbad.experiments.dataset;

import java.nio.file.Path;
import java.util.Optional;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SensorFile;
import simbad.sonar.scene.SonarSpec;

/** The sonar of a log: one that is known by name or from a file, and what differs from it. */
final class LogSonar {
  private static final double FURTHEST_M = 100;

  private LogSonar() {}

  /**
   * Reads it.
   *
   * @param settings what is said of it
   * @param assumptions take what is not
   */
  static SonarSpec of(LogSettings settings, Assumptions assumptions) throws DataFormatException {
    if (!settings.has("sonar")) {
      assumptions.add("The sonar is an HC-SR04 by its data sheet (--sonar).");
    }
    SonarSpec known = known(settings.find("sonar").orElse("hc-sr04"));
    if (!settings.has("sound-speed")) {
      assumptions.add(
          "Ranges were computed with a speed of sound of "
              + known.assumedSoundSpeedMPerS()
              + " m/s (--sound-speed).");
    }
    double least = length(settings, "min-range", 0).orElse(known.minRangeM());
    double most = length(settings, "max-range", 1e-3).orElse(known.maxRangeM());
    if (!(least < most)) {
      throw LogSettings.fault(
          settings.has("min-range") ? "min-range" : "max-range",
          "the least range of " + least + " m is not below the greatest of " + most + " m");
    }
    Optional<Double> cone = settings.findMeasure("cone", Unit.Kind.ANGLE);
    if (cone.isPresent() && !(cone.get() > 1e-3 && cone.get() <= 180)) {
      throw LogSettings.fault("cone", cone.get() + " degrees is not in (0, 180]");
    }
    return new SonarSpec(
        known.name(),
        cone.map(Math::toRadians).orElse(known.coneHalfAngleRad()),
        least,
        most,
        length(settings, "height", 0).orElse(known.mountHeightM()),
        settings.findNumber("sound-speed", 100, 2000).orElse(known.assumedSoundSpeedMPerS()),
        known.resolutionM(),
        known.rangeNoiseM(),
        known.missRate(),
        known.edgeWidthM(),
        periodS(settings).orElse(known.updatePeriodS()),
        known.law());
  }

  static SonarSpec withResolution(SonarSpec sonar, double resolutionM) {
    return new SonarSpec(
        sonar.name(),
        sonar.coneHalfAngleRad(),
        sonar.minRangeM(),
        sonar.maxRangeM(),
        sonar.mountHeightM(),
        sonar.assumedSoundSpeedMPerS(),
        resolutionM,
        sonar.rangeNoiseM(),
        sonar.missRate(),
        sonar.edgeWidthM(),
        sonar.updatePeriodS(),
        sonar.law());
  }

  /** Finds the time from ping to ping. */
  static Optional<Double> periodS(LogSettings settings) throws DataFormatException {
    Optional<Double> period = settings.findMeasure("period", Unit.Kind.TIME);
    if (period.isPresent() && !(period.get() > 0 && period.get() <= 1e6)) {
      throw LogSettings.fault("period", period.get() + " s is not in (0, 1e6]");
    }
    return period;
  }

  /** Finds a length between a least one and the furthest that a threshold may be. */
  static Optional<Double> length(LogSettings settings, String option, double leastM)
      throws DataFormatException {
    Optional<Double> length = settings.findMeasure(option, Unit.Kind.LENGTH);
    if (length.isPresent() && !(length.get() >= leastM && length.get() <= FURTHEST_M)) {
      throw LogSettings.fault(
          option, length.get() + " m is not in [" + leastM + ", " + FURTHEST_M + "]");
    }
    return length;
  }

  private static SonarSpec known(String word) throws DataFormatException {
    Optional<SonarSpec> known = Catalogue.findSonar(word);
    if (known.isPresent()) {
      return known.get();
    }
    Optional<Path> file = LogSettings.findFile(word);
    if (file.isPresent()) {
      return SensorFile.read(file.get());
    }
    throw LogSettings.fault(
        "sonar",
        "'" + word + "' is neither " + String.join(", ", Catalogue.sonars()) + " nor a JSON file");
  }
}
