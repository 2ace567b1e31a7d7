package simbad.experiments.dataset;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/** What a log does not say and was decided, as sentences; each once. */
final class Assumptions {
  private final Set<String> sentences = new LinkedHashSet<>();

  /** Returns a number of things, such as 1 row, 2 rows. */
  static String counted(long count, String what) {
    return count + " " + what + (count == 1 ? "" : "s");
  }

  void add(String sentence) {
    sentences.add(sentence);
  }

  List<String> sentences() {
    return List.copyOf(sentences);
  }
}
