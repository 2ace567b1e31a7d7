package simbad.experiments.run;

import java.nio.file.Path;
import java.util.Optional;

/** The word for what a diagnosis left, of sensing or of motion: "diagnosed:" and its folder. */
public final class DiagnosedFolder {
  /** What stands before the folder. */
  public static final String PREFIX = "diagnosed:";

  private DiagnosedFolder() {}

  /**
   * Returns the folder that a word names, as it is written there.
   *
   * @return empty where the word does not begin with {@value #PREFIX}
   */
  public static Optional<String> in(String word) {
    return word.startsWith(PREFIX)
        ? Optional.of(word.substring(PREFIX.length()))
        : Optional.empty();
  }

  /** Returns the name that the last part of a path has; empty where it has none. */
  static Optional<String> name(Path path) {
    return Optional.ofNullable(path.toAbsolutePath().normalize().getFileName()).map(Path::toString);
  }
}
