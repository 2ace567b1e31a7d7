package simbad.cli;

import java.io.File;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.cli.machine.Launcher;

/** The user's own jars and folders, which the launcher adds to the class path. */
final class OwnClasses {
  private static final String VARIABLE = "SIMBAD_CLASS_PATH";

  /** All jars of a folder, for Java. */
  private static final String ALL_JARS = "/*";

  private OwnClasses() {}

  /**
   * Tells whether all are there that the user named; Java would pass over others without a word.
   *
   * @param err told which is not
   */
  static boolean areThere(PrintWriter err) {
    if (Launcher.ofThisProcess().isEmpty()) {
      return true;
    }
    Optional<String> missing = missing(named());
    missing.ifPresent(
        entry ->
            err.println("simbad: " + VARIABLE + ": " + entry + ": there is no such jar or folder"));
    return missing.isEmpty();
  }

  /** The user's class path, empty where there is none. */
  static String named() {
    return System.getenv().getOrDefault(VARIABLE, "");
  }

  /** The first entry of a class path that is not there. */
  static Optional<String> missing(String classPath) {
    return Stream.of(classPath.split(File.pathSeparator, -1))
        .filter(entry -> !entry.isEmpty())
        .filter(entry -> !Files.exists(Path.of(folder(entry))))
        .findFirst();
  }

  private static String folder(String entry) {
    return entry.endsWith(ALL_JARS)
        ? entry.substring(0, entry.length() - ALL_JARS.length())
        : entry;
  }
}
