package simbad.experiments.cli;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Collectors;
import simbad.obstacles.Catalogue;
import simbad.obstacles.CrossSections;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TableFile;

/**
 * An obstacle as named on the command line: a type of the catalogue or a threshold table's file.
 */
final class ObstacleArgument {
  private static final String SUFFIX = ".csv";

  private ObstacleArgument() {}

  /** A table of one's own comes without a cross-section: it stands for the one inch round post. */
  static ObstacleType parse(String argument) throws DataFormatException {
    // A name of the catalogue stays one beside a file or folder that is called the same.
    Optional<ObstacleType> known = Catalogue.find(argument);
    if (known.isPresent()) {
      return known.get();
    }
    Path file = path(argument);
    if (argument.endsWith(SUFFIX) || argument.contains("/") || Files.exists(file)) {
      return new ObstacleType(name(file), CrossSections.round(), TableFile.read(file));
    }
    throw unknown(argument);
  }

  private static Path path(String argument) throws DataFormatException {
    try {
      if (!argument.isEmpty()) {
        return Path.of(argument);
      }
    } catch (InvalidPathException e) {
      // Said below.
    }
    throw unknown(argument);
  }

  private static DataFormatException unknown(String argument) {
    return DataFormatException.inArgument(
        "OBSTACLE '" + argument + "'",
        "is neither " + names() + " nor a table's file (*" + SUFFIX + ")");
  }

  private static String name(Path file) {
    String name = String.valueOf(file.getFileName());
    String stem = name.endsWith(SUFFIX) ? name.substring(0, name.length() - SUFFIX.length()) : name;
    // The name becomes a folder and part of a page. Without a dot it is none of the run's own
    // files.
    String plain = stem.replaceAll("[^\\p{L}\\p{N}_-]", "_");
    return plain.isEmpty() ? "table" : plain;
  }

  private static String names() {
    return Catalogue.types().stream().map(ObstacleType::name).collect(Collectors.joining(", "));
  }
}
