package simbad.gap.calibrate;

import simbad.gap.fit.Hypothesis;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;

/**
 * What differs from one day to the next though nothing was changed: the air's temperature by half a
 * degree and its absorption with it, a supply's voltage, what was put up again by tape and
 * protractor. A set-up that is known to a decibel would show each of these as an effect.
 */
final class DaysDifference {
  private DaysDifference() {}

  /**
   * Returns a set-up with what of an explanation is no more than that.
   *
   * @param setup as known
   * @param explanation of a log of another day
   */
  static Hypothesis taken(Hypothesis setup, Hypothesis explanation) {
    Hypothesis taken = setup;
    for (int i = 0; i < explanation.forms().size(); i++) {
      Form form = explanation.forms().get(i);
      double[] values = explanation.valuesOf(i);
      Form asSetup = SetupForms.of(form);
      if (Definitions.of(form.effect()).isWithinDays(form, values)
          && !setup.forms().contains(asSetup)) {
        taken = taken.and(asSetup, values);
      }
    }
    return taken;
  }
}
