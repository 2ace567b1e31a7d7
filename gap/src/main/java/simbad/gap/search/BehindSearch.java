package simbad.gap.search;

import java.util.ArrayList;
import java.util.List;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Screen;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Tries;

/**
 * Where to begin with two at a time: with what takes echoes away, and with what is heard in their
 * place. The first alone gains nothing where no reading is silent, the second alone nothing where
 * no silence is believed in.
 */
final class BehindSearch {
  private BehindSearch() {}

  /**
   * Returns such pairs of what the log invites.
   *
   * @param given the log
   * @param forms that are looked for
   * @return none of a log that invites nothing
   */
  static List<Hypothesis> starts(CalibratedLog given, List<Form> forms) {
    List<Form> behind = forms.stream().filter(BehindSearch::isHeardInSilence).toList();
    List<Form> away =
        Gates.invited(given, forms).stream().filter(form -> !isHeardInSilence(form)).toList();
    List<Hypothesis> starts = new ArrayList<>();
    for (Form form : away) {
      for (double[] values : Tries.all(form)) {
        Fit base = new Fitter(given, Fold.ALL).refine(Hypothesis.NONE.and(form, values), 0);
        new Screen(given, base).all(behind).values().forEach(fit -> starts.add(fit.hypothesis()));
      }
    }
    return starts;
  }

  private static boolean isHeardInSilence(Form form) {
    return Definitions.of(form.effect()).isHeardInSilence(form.name());
  }
}
