package simbad.cli;

import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;

/** What a sweep goes round, and in which air. */
final class SweptObstacle {
  @Option(
      names = "--obstacle",
      paramLabel = "NAME",
      required = true,
      description = "The obstacle to sweep round. " + ObstacleArgument.MEANING)
  private String name = "";

  @Option(
      names = "--temperature",
      paramLabel = "CELSIUS",
      description = "Temperature of the air, degrees Celsius. Default: not known; 20 is assumed.")
  private @Nullable Double temperatureC;

  /** As it was typed. */
  String name() {
    return name;
  }

  ObstacleType type() throws DataFormatException {
    return ObstacleArgument.parse(name);
  }

  OptionalDouble temperatureC() {
    return temperatureC == null ? OptionalDouble.empty() : OptionalDouble.of(temperatureC);
  }
}
