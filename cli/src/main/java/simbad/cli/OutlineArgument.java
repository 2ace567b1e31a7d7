package simbad.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OutlineDocument;
import simbad.sonar.format.OutlineFile;

/**
 * A cross-section on the command line: an obstacle's name, an outline's file, or a folder with one.
 */
final class OutlineArgument {
  private OutlineArgument() {}

  static OutlineDocument parse(String argument) throws DataFormatException {
    if (ObstacleArgument.isPath(argument)) {
      Path path = Path.of(argument);
      return OutlineFile.read(Files.isDirectory(path) ? path.resolve("outline.csv") : path);
    }
    Optional<ObstacleType> known = Catalogue.findAny(argument);
    if (known.isEmpty()) {
      throw ObstacleArgument.unknown(argument);
    }
    ObstacleType type = known.get();
    return new OutlineDocument(
        type.parts(), Map.of("object", type.thresholds().header("object").orElse(type.name())));
  }
}
