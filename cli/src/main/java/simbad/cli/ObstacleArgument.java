package simbad.cli;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleFiles;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;

/**
 * An obstacle as named on the command line: a type of the catalogue, a threshold table's file, or a
 * folder with an outline and a table.
 */
final class ObstacleArgument {
  private static final String SUFFIX = ".csv";

  /** For help. */
  static final String MEANING =
      "The name of a type (simbad table types), a folder with outline.csv and "
          + "table.csv, or TABLE.csv with TABLE-outline.csv beside it. A TABLE.csv without "
          + "an outline counts as a round post of one inch.";

  private ObstacleArgument() {}

  /** A table of one's own without a cross-section stands for the one inch round post. */
  static ObstacleType parse(String argument) throws DataFormatException {
    if (argument.endsWith(SUFFIX) || argument.contains("/")) {
      return ObstacleFiles.read(path(argument));
    }
    // A name of the catalogue stays one beside a file or folder that is called the same.
    Optional<ObstacleType> known = Catalogue.findAny(argument);
    if (known.isPresent()) {
      return known.get();
    }
    if (isPath(argument)) {
      return ObstacleFiles.read(path(argument));
    }
    throw unknown(argument);
  }

  /** Obstacles no two of which have a name in common: results lie in folders that are called so. */
  static List<ObstacleType> distinct(List<String> arguments) throws DataFormatException {
    List<ObstacleType> types = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (String argument : arguments) {
      ObstacleType type = parse(argument);
      if (!names.add(type.name().toLowerCase(Locale.ROOT))) {
        throw DataFormatException.inArgument("OBSTACLE", "two are called " + type.name());
      }
      types.add(type);
    }
    return types;
  }

  /** Tells whether an argument can be meant as a file or folder. */
  static boolean isPath(String argument) throws DataFormatException {
    return argument.endsWith(SUFFIX)
        || argument.contains("/")
        || (Files.exists(path(argument)) && Catalogue.findAny(argument).isEmpty());
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

  /** What to say of a word that names no obstacle; the user's own types are among those named. */
  static DataFormatException unknown(String argument) throws DataFormatException {
    List<String> names = Catalogue.all().stream().map(ObstacleType::name).toList();
    return DataFormatException.inArgument(
        "'" + argument + "'",
        "no such obstacle, expected "
            + String.join(", ", names)
            + ", a table's file (*"
            + SUFFIX
            + ") or a folder with outline and table"
            + SimilarWords.suggestion(argument, names));
  }
}
