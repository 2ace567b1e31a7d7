package simbad.sonar.catalogue;

import java.util.List;
import java.util.stream.IntStream;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Tries;

/** Where a gate may begin or end: at distances that obstacles had. */
final class Distances {
  private static final int QUANTILES = 20;

  private Distances() {}

  /** The tries of a form whose first parameter is a distance, which takes those of the log. */
  static List<List<Double>> first(Form form, Clues clues) {
    List<List<Double>> tries = Tries.of(form);
    double[] sorted = clues.audibleM().sorted().toArray();
    if (sorted.length > 0) {
      tries.set(
          0,
          IntStream.rangeClosed(1, QUANTILES)
              .mapToObj(i -> Modes.quantile(sorted, (double) i / (QUANTILES + 1)))
              .toList());
    }
    return tries;
  }
}
