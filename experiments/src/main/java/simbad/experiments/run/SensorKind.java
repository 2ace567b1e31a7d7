package simbad.experiments.run;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import simbad.experiments.plot.SeriesRole;
import simbad.obstacles.SonarBelt;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.scene.SonarSpec;

/** The sensors that a run compares, by the names of the command line. */
public enum SensorKind {
  /** Simbad's sensor as the thesis describes it: every obstacle is heard up to 2.5 m. */
  ORIGINAL(SeriesRole.ORIGINAL, "cone, every obstacle heard up to 2.5 m"),
  /** Simbad's sensor as its program has it: thin rays of 2.5 m. */
  RAY(SeriesRole.RAY, "Simbad's thin rays of 2.5 m"),
  /** Cone and shadow, the sensor inside the shadow. */
  SHADOW(SeriesRole.SHADOW, "obstacle in the cone, sensor in the detection shadow"),
  /** Cone and shadow overlap anywhere. */
  OVERLAP(SeriesRole.OVERLAP, "cone and detection shadow overlap"),
  /** The shadow sensor with the nominal model's noise. */
  NOISY(SeriesRole.NOISY, "nominal model: misses, soft threshold, range noise");

  /** Number of sonars on the belt; with half angles over 15 degrees their cones look all round. */
  public static final int SONARS = 12;

  private final SeriesRole role;
  private final String meaning;

  SensorKind(SeriesRole role, String meaning) {
    this.role = role;
    this.meaning = meaning;
  }

  /** Returns the name on the command line and in files. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Returns in a few words when this sensor hears an obstacle. */
  public String meaning() {
    return meaning;
  }

  /** Returns how this sensor's curves are drawn. */
  public SeriesRole role() {
    return role;
  }

  /**
   * Finds a sensor by its name.
   *
   * @param word as on the command line
   */
  public static Optional<SensorKind> find(String word) {
    return Arrays.stream(values()).filter(kind -> kind.word().equals(word)).findFirst();
  }

  /** Returns all names, separated by commas. */
  public static String words() {
    return Arrays.stream(values()).map(SensorKind::word).collect(Collectors.joining(", "));
  }

  /** The belt of this sensor, all transducers at its centre. */
  RangeSensorBelt belt(SonarSpec spec, RandomGenerator random) {
    return switch (this) {
      case RAY ->
          new RangeSensorBelt(
              0, 0, (float) DetectionRule.ORIGINAL_RANGE_M, SONARS, RangeSensorBelt.TYPE_SONAR, 0);
      case ORIGINAL -> new SonarBelt(SONARS, spec, DetectionRule.ORIGINAL, random);
      case SHADOW -> new SonarBelt(SONARS, spec, DetectionRule.SHADOW, random);
      case OVERLAP -> new SonarBelt(SONARS, spec, DetectionRule.OVERLAP, random);
      case NOISY -> new SonarBelt(SONARS, spec, DetectionRule.NOISY, random);
    };
  }
}
