package simbad.cli;

import java.util.List;
import simbad.experiments.run.SensorKind;

/** A sensor on the command line that {@link SensorKind} does not know. */
final class SensorArgument {
  private SensorArgument() {}

  /** What to say of a word that names no sensor. */
  static String unknown(String word) {
    List<String> known = List.of(SensorKind.words().split(", "));
    return "'"
        + word
        + "' is not one of "
        + SensorKind.words()
        + SimilarWords.suggestion(word, known);
  }
}
