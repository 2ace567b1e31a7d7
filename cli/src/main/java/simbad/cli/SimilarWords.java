package simbad.cli;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;

/** Finds what somebody may have meant who mistyped a name. */
final class SimilarWords {
  /** One slip in so many letters, and one more, is still a slip. */
  private static final int LETTERS_PER_SLIP = 4;

  private SimilarWords() {}

  /** Returns the name that was probably meant; empty where none is near enough. */
  static Optional<String> find(String word, Collection<String> names) {
    return names.stream()
        .min(Comparator.comparingInt(name -> changes(name, word)))
        .filter(name -> changes(name, word) <= 1 + name.length() / LETTERS_PER_SLIP);
  }

  /** Returns {@code "; did you mean NAME?"}, or nothing where no name is near enough. */
  static String suggestion(String word, Collection<String> names) {
    return find(word, names).map(name -> "; did you mean " + name + "?").orElse("");
  }

  /** Letters to add, drop or replace that turn one word into another (Levenshtein, 1966). */
  static int changes(String oneName, String otherName) {
    String one = oneName.toLowerCase(Locale.ROOT);
    String other = otherName.toLowerCase(Locale.ROOT);
    int[] row = new int[other.length() + 1];
    for (int j = 0; j <= other.length(); j++) {
      row[j] = j;
    }
    for (int i = 1; i <= one.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j <= other.length(); j++) {
        int replaced = diagonal + (one.charAt(i - 1) == other.charAt(j - 1) ? 0 : 1);
        diagonal = row[j];
        row[j] = Math.min(replaced, 1 + Math.min(row[j], row[j - 1]));
      }
    }
    return row[other.length()];
  }
}
