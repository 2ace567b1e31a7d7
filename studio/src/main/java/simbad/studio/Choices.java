package simbad.studio;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.Catalogue;
import simbad.sonar.scene.SonarSpec;

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
