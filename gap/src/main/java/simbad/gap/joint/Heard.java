package simbad.gap.joint;

import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Estimate;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.IntervalWidths;
import simbad.gap.score.Uncertainty;
import simbad.sonar.effect.Form;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensorLaw;

/** What readings say of a value beside what was found in them. */
final class Heard {
  private static final int EVALUATIONS = 40;

  private final CalibratedLog given;
  private final Hypothesis found;

  Heard(DataSet data, Diagnosis diagnosis) {
    given =
        new CalibratedLog(
            data.setup(), diagnosis.calibration().changes(), new PingLog(data.readings()));
    found = diagnosis.fitted();
  }

  /**
   * Estimates a form's one value: from where it was found, from where the other half says, and from
   * where nothing changes, whichever makes the readings likeliest.
   *
   * @param form with one parameter
   * @param offered value that the other half says
   */
  Estimate estimate(Form form, double offered) {
    Fitter fitter = new Fitter(given, Fold.ALL);
    Hypothesis others = found.without(form.effect());
    Hypothesis start = beside(others, form, form.parameters().get(0).clamp(offered));
    Fit best = fitter.polish(start, EVALUATIONS * start.size());
    Fit still = fitter.refine(beside(others, form, form.neutral()[0]), EVALUATIONS * start.size());
    best = still.logLikelihood() > best.logLikelihood() ? still : best;
    if (found.forms().contains(form)) {
      Fit own = fitter.refine(found, 0);
      best = own.logLikelihood() >= best.logLikelihood() ? own : best;
    }
    Hypothesis set = best.hypothesis();
    int at = 0;
    for (int i = 0; i < set.forms().indexOf(form); i++) {
      at += set.forms().get(i).parameters().size();
    }
    boolean isLevel = given.setup().sensor().law().isLevel();
    double wider =
        IntervalWidths.own().under(isLevel ? SensorLaw.Model.LEVEL : SensorLaw.Model.THRESHOLD);
    return new Estimate(set.values()[at], wider * new Uncertainty(given, 1).deviations(set)[at]);
  }

  private static Hypothesis beside(Hypothesis others, Form form, double value) {
    return others.and(form, value);
  }

  /** Returns what was found with a form at a value, in the place of its effect's other forms. */
  static Hypothesis with(Hypothesis found, Form form, double value) {
    Hypothesis with = Hypothesis.NONE;
    boolean isNew = true;
    for (int i = 0; i < found.forms().size(); i++) {
      Form one = found.forms().get(i);
      if (one.equals(form)) {
        with = with.and(form, value);
        isNew = false;
      } else if (one.effect() != form.effect()) {
        with = with.and(one, found.valuesOf(i));
      }
    }
    return isNew ? with.and(form, value) : with;
  }
}
