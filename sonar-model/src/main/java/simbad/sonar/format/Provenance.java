package simbad.sonar.format;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/** Where the numbers of a threshold table come from. */
public enum Provenance {
  /** On a bench, by somebody who published them. */
  MEASURED,
  /** On a bench, with this project's capture program. */
  CAPTURED,
  /** From what is known in words of a table that was measured but not published. */
  RECONSTRUCTED,
  /** From a cross-section, by computation. */
  PREDICTED;

  /** Returns the word that stands in files and on plots. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** Finds the provenance that a word means. */
  static Optional<Provenance> find(String word) {
    return Arrays.stream(values()).filter(value -> value.word().equals(word)).findFirst();
  }

  static String words() {
    return Arrays.stream(values()).map(Provenance::word).collect(Collectors.joining(", "));
  }
}
