package simbad.studio;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.experiments.diagnosis.DiagnosisFolder;
import simbad.experiments.run.DiagnosedFolder;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.SensorKind;
import simbad.motion.format.DiagnosedMotion;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.scene.SonarSpec;
import simbad.studio.folders.Folders;

/**
 * What a scene can be made of besides the obstacles of the catalogue.
 *
 * @param sensors how a sonar may hear, the first at the beginning; names distinct
 * @param robots that do not do exactly what they are told; names distinct
 * @param options how the command line says those of them whose names it does not know
 */
public record Choices(
    List<SensorKind> sensors, List<RobotKind> robots, Map<String, String> options) {
  /** The sonar of a scene that names none. */
  static final String SONAR = "srf04";

  /** Copies all. */
  public Choices {
    sensors = List.copyOf(sensors);
    robots = List.copyOf(robots);
    options = Map.copyOf(options);
  }

  /** Creates choices whose names are those of the command line. */
  public Choices(List<SensorKind> sensors, List<RobotKind> robots) {
    this(sensors, robots, Map.of());
  }

  /** Returns what everybody has: that of the main experiment first. */
  public static Choices plain() {
    Stream<SensorKind> others =
        SensorKind.all().stream().filter(kind -> !kind.equals(SensorKind.SHADOW));
    return new Choices(Stream.concat(Stream.of(SensorKind.SHADOW), others).toList(), List.of());
  }

  /**
   * Returns these, and what the diagnoses in a folder left: sensors and robots. One that cannot be
   * read is left out, for its own page says why, and so is one whose name is taken.
   *
   * @throws DataFormatException if the folder cannot be read
   */
  public Choices with(Folders folders) throws DataFormatException {
    List<SensorKind> allSensors = new ArrayList<>(sensors);
    List<RobotKind> allRobots = new ArrayList<>(robots);
    Map<String, String> allOptions = new HashMap<>(options);
    for (Path folder : folders.diagnoses(DiagnosisFolder.MODEL)) {
      String word = DiagnosedFolder.PREFIX + folder;
      read(() -> SensorKind.read(word))
          .filter(kind -> isFree(allSensors.stream().map(SensorKind::word), kind.word()))
          .ifPresent(
              kind -> {
                allSensors.add(kind);
                allOptions.putIfAbsent(kind.word(), word);
              });
    }
    for (Path folder : folders.diagnoses(DiagnosedMotion.MODEL)) {
      String word = DiagnosedFolder.PREFIX + folder;
      read(() -> Optional.of(RobotKind.read(word)))
          .filter(kind -> isFree(allRobots.stream().map(RobotKind::name), kind.name()))
          .ifPresent(
              kind -> {
                allRobots.add(kind);
                allOptions.putIfAbsent(kind.name(), word);
              });
    }
    return new Choices(allSensors, allRobots, allOptions);
  }

  /** What reads a kind from its files. */
  @FunctionalInterface
  private interface Reading<T> {
    Optional<T> kind() throws DataFormatException;
  }

  private static <T> Optional<T> read(Reading<T> reading) {
    try {
      return reading.kind();
    } catch (DataFormatException e) {
      return Optional.empty();
    }
  }

  private static boolean isFree(Stream<String> taken, String name) {
    return taken.noneMatch(name::equals);
  }

  /** What the command line has for a sensor or a robot. */
  String option(String name) {
    return options.getOrDefault(name, name);
  }

  Optional<SensorKind> findSensor(String word) {
    return sensors.stream().filter(kind -> kind.word().equals(word)).findFirst();
  }

  Optional<RobotKind> findRobot(String name) {
    return robots.stream().filter(kind -> kind.name().equals(name)).findFirst();
  }

  /** The figures that a sensor hears with: a diagnosed one brings its own. */
  static SonarSpec sonar(SensorKind sensor, SonarSpec chosen) {
    return sensor.model().map(model -> model.setup().sensor()).orElse(chosen);
  }

  /** The figures of a sonar of the catalogue. */
  static Optional<SonarSpec> findSonar(String name) {
    return Catalogue.sonars().contains(name) ? Catalogue.findSonar(name) : Optional.empty();
  }
}
