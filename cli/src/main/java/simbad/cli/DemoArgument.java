package simbad.cli;

import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import simbad.demo.Demo;
import simbad.demo.DemoManager;
import simbad.experiments.demo.ObstacleDemo;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;

/** A demo as named on the command line. */
final class DemoArgument {
  private static final String SUFFIX = "demo";
  private static final int SUGGESTIONS = 3;

  private DemoArgument() {}

  /**
   * Makes a demo; small letters and a name without Demo will do. An obstacle's name or path, where
   * it is no demo's, gives the robot that circles it.
   */
  static Optional<Demo> find(String argument) throws DataFormatException {
    Optional<Demo> demo =
        DemoManager.names().stream()
            .filter(name -> plain(name).equals(plain(argument)))
            .findFirst()
            .flatMap(DemoManager::find);
    if (demo.isPresent()) {
      return demo;
    }
    return ObstacleArgument.isPath(argument)
        ? Optional.of(new ObstacleDemo(ObstacleArgument.parse(argument)))
        : Catalogue.findAny(argument).map(ObstacleDemo::new);
  }

  /** What to say of a name that is none: those that are nearest to it. */
  static String unknown(String argument) {
    String nearest =
        DemoManager.names().stream()
            .sorted(
                Comparator.comparingInt(name -> SimilarWords.changes(plain(name), plain(argument))))
            .limit(SUGGESTIONS)
            .collect(Collectors.joining(", "));
    return "'"
        + argument
        + "' is not a demo, did you mean "
        + nearest
        + "? simbad demo --list shows all";
  }

  private static String plain(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(SUFFIX) ? lower.substring(0, lower.length() - SUFFIX.length()) : lower;
  }
}
