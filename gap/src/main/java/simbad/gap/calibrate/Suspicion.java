package simbad.gap.calibrate;

import java.util.Arrays;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.GapMeter;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Form;

/** Whether what explains a log was there already when the reference was taken. */
final class Suspicion {
  /** What the reference must gain by an effect to show it. */
  private static final double SHOWN_NATS = 4;

  /** What the reference must lose by an effect to rule it out. */
  private static final double OPEN_NATS = 3;

  /** A value that the reference shows too explains at least this share of what the log shows. */
  private static final double SAME_SHARE = 0.25;

  /** What the reference leaves open is the set-up's when it shrinks the gap by less. */
  private static final double SMALL_SHARE = 0.1;

  private final CalibratedLog log;
  private final Hypothesis explanation;
  private final double clumping;
  private final Fitter fitter;
  private final Fitter own;

  /**
   * Creates a suspicion.
   *
   * @param reference without any calibration
   * @param log calibrated
   * @param explanation of the log
   * @param clumping by how much readings hang together
   */
  Suspicion(CalibratedLog reference, CalibratedLog log, Hypothesis explanation, double clumping) {
    this.log = log;
    this.explanation = explanation;
    this.clumping = clumping;
    fitter = new Fitter(reference, Fold.ALL);
    own = new Fitter(log, Fold.ALL);
  }

  /**
   * Adds one form of the explanation to the set-up if it belongs there.
   *
   * @param known of the set-up
   * @param index of the form
   */
  Hypothesis settled(Hypothesis known, int index) {
    Form form = SetupForms.of(explanation.forms().get(index));
    double[] values = explanation.valuesOf(index);
    if (known.forms().contains(form) || form.isTable()) {
      return known;
    }
    double nothing = fitter.logLikelihood(known);
    Hypothesis there = known.and(form, values);
    Fit shown = fitter.refine(there, known.size(), 30 + 20 * values.length);
    if (shown.logLikelihood() - nothing > SHOWN_NATS * clumping
        && isSame(index, shown.hypothesis().valuesOf(known.forms().size()))) {
      return shown.hypothesis();
    }
    boolean open = fitter.logLikelihood(there) > nothing - OPEN_NATS;
    return open && isSmall(index) ? there : known;
  }

  /** Whether the value that the reference shows explains much of what the log shows. */
  private boolean isSame(int index, double[] shown) {
    Form form = explanation.forms().get(index);
    double nothing = own.logLikelihood(Hypothesis.NONE);
    double same = own.logLikelihood(Hypothesis.NONE.and(form, shown)) - nothing;
    double all =
        own.logLikelihood(Hypothesis.NONE.and(form, explanation.valuesOf(index))) - nothing;
    return same > SAME_SHARE * all;
  }

  private boolean isSmall(int index) {
    Effect effect = explanation.forms().get(index).effect();
    double with = gapM(explanation);
    return gapM(explanation.without(effect)) * (1 - SMALL_SHARE) < with;
  }

  private double gapM(Hypothesis hypothesis) {
    double[] gaps = new GapMeter(log).measure(log, hypothesis).observedM();
    return Arrays.stream(gaps).average().orElse(0);
  }
}
