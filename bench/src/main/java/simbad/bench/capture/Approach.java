package simbad.bench.capture;

import java.util.Locale;
import java.util.Optional;

/** Why a distance was tried. */
public enum Approach {
  /** To find out roughly where the threshold is. */
  SEARCH,
  /** On the way out, until the echo is lost. */
  OUT,
  /** On the way in, until the echo is back. */
  IN;

  /** Returns the word in a journal. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  static Optional<Approach> find(String word) {
    for (Approach approach : values()) {
      if (approach.word().equals(word)) {
        return Optional.of(approach);
      }
    }
    return Optional.empty();
  }
}
