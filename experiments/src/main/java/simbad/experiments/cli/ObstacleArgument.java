package simbad.experiments.cli;

import java.nio.file.Files;
import java.nio.file.Path;
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
    Path file = Path.of(argument);
    if (argument.endsWith(SUFFIX) || argument.contains("/") || Files.exists(file)) {
      return new ObstacleType(name(file), CrossSections.round(), TableFile.read(file));
    }
    return Catalogue.find(argument)
        .orElseThrow(
            () ->
                DataFormatException.inArgument(
                    "OBSTACLE '" + argument + "'",
                    "is neither " + names() + " nor a table's file (*" + SUFFIX + ")"));
  }

  private static String name(Path file) {
    String name = String.valueOf(file.getFileName());
    String stem = name.endsWith(SUFFIX) ? name.substring(0, name.length() - SUFFIX.length()) : name;
    // The name becomes a folder and part of a page.
    String plain = stem.replaceAll("[^\\p{L}\\p{N}._-]", "_");
    return plain.matches("\\.*") ? "table" : plain;
  }

  private static String names() {
    return Catalogue.types().stream().map(ObstacleType::name).collect(Collectors.joining(", "));
  }
}
