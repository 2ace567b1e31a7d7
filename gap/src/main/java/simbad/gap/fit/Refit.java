package simbad.gap.fit;

import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;

/**
 * Fits a hypothesis that is known roughly once more, to some of the pings: values by simplex,
 * tables of thresholds, which have too many values for it, read off the log anew.
 */
public final class Refit {
  private final CalibratedLog given;
  private final Fold fold;
  private final Fitter fitter;

  /**
   * Creates for the pings that count.
   *
   * @param given the log
   * @param fold the pings that count
   */
  public Refit(CalibratedLog given, Fold fold) {
    this.given = given;
    this.fold = fold;
    fitter = new Fitter(given, fold);
  }

  /** Returns the fitter of the pings that count. */
  public Fitter fitter() {
    return fitter;
  }

  /** A table is read off the log, not searched. */
  private static double[] read(Form form, Clues clues) {
    return Definitions.of(form.effect()).starts(form, clues).get(0);
  }

  /**
   * Fits all values again.
   *
   * @param start known roughly
   * @param evaluations for each value that is no threshold
   */
  public Hypothesis of(Hypothesis start, int evaluations) {
    Hypothesis tables = Hypothesis.NONE;
    Hypothesis rest = Hypothesis.NONE;
    for (int i = 0; i < start.forms().size(); i++) {
      Form form = start.forms().get(i);
      if (form.isTable()) {
        LogClues clues = new LogClues(given, start.without(form.effect()), fold);
        tables = tables.and(form, read(form, clues));
      } else {
        rest = rest.and(form, start.valuesOf(i));
      }
    }
    int most = evaluations * (1 + rest.size());
    if (tables.size() == 0) {
      return fitter.settle(start, 0, 0, most).hypothesis();
    }
    Hypothesis both = tables;
    for (int i = 0; i < rest.forms().size(); i++) {
      both = both.and(rest.forms().get(i), rest.valuesOf(i));
    }
    return fitter.refine(both, tables.size(), rest.size() == 0 ? 0 : most).hypothesis();
  }
}
