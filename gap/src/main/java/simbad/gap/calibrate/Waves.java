package simbad.gap.calibrate;

import simbad.gap.fit.Fitter;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Form;

/**
 * Fits the coefficients of a threshold's waves by one step of Newton each, since they hardly depend
 * on one another, with a Gaussian prior round zero for each.
 */
final class Waves {
  private static final double STEP = 0.01;
  private static final double FARTHEST = 0.04;

  private final Fitter fitter;
  private final Form form;

  Waves(Fitter fitter, Form form) {
    this.fitter = fitter;
    this.form = form;
  }

  /**
   * What the readings say of each coefficient near its value, without the prior.
   *
   * @param slope first derivative of the likelihood, extrapolated to a coefficient of zero
   * @param curve second derivative, negated; positive where the readings tell something
   */
  @SuppressWarnings("ArrayRecordComponent") // one value for each coefficient; read only
  record Lie(double[] slope, double[] curve) {
    /**
     * Returns how much better coefficients of some spread predict than none, in nats: the marginal
     * likelihood of a quadratic one.
     *
     * @param variance of the prior
     */
    double worth(double variance) {
      double sum = 0;
      for (int i = 0; i < slope.length; i++) {
        double known = 1 + variance * curve[i];
        sum += (slope[i] * slope[i] * variance / known - Math.log(known)) / 2;
      }
      return sum;
    }
  }

  /** Returns a hypothesis that has the waves, at zero if it had none. */
  Hypothesis in(Hypothesis base) {
    return base.forms().contains(form) ? base : base.and(form, form.neutral());
  }

  Lie lie(Hypothesis base) {
    Hypothesis with = in(base);
    int from = offset(with);
    double[] values = with.values();
    double here = fitter.logLikelihood(with);
    double[] slope = new double[form.parameters().size()];
    double[] curve = new double[slope.length];
    for (int i = 0; i < slope.length; i++) {
      double high = at(with, values, from + i, STEP);
      double low = at(with, values, from + i, -STEP);
      curve[i] = Math.max(0, (2 * here - high - low) / (STEP * STEP));
      slope[i] = (high - low) / (2 * STEP) + curve[i] * values[from + i];
    }
    return new Lie(slope, curve);
  }

  /**
   * Moves each coefficient once.
   *
   * @param base has the waves or not
   * @param variance of the prior, one for each coefficient; positive
   */
  Hypothesis moved(Hypothesis base, double[] variance) {
    Hypothesis with = in(base);
    int from = offset(with);
    double[] values = with.values();
    double here = fitter.logLikelihood(with);
    for (int i = 0; i < variance.length; i++) {
      int at = from + i;
      double high = at(with, values, at, STEP);
      double low = at(with, values, at, -STEP);
      double curve = Math.max(0, (2 * here - high - low) / (STEP * STEP)) + 1 / variance[i];
      double slope = (high - low) / (2 * STEP) - values[at] / variance[i];
      double move = Math.max(-FARTHEST, Math.min(FARTHEST, slope / curve));
      double there = at(with, values, at, move);
      double was = values[at];
      double cost = ((was + move) * (was + move) - was * was) / (2 * variance[i]);
      if (there - cost > here) {
        values[at] += move;
        here = there;
      }
    }
    return with.with(values);
  }

  private double at(Hypothesis with, double[] values, int index, double by) {
    double[] moved = values.clone();
    moved[index] += by;
    return fitter.logLikelihood(with.with(moved));
  }

  private int offset(Hypothesis hypothesis) {
    int from = 0;
    for (Form each : hypothesis.forms()) {
      if (each.equals(form)) {
        break;
      }
      from += each.parameters().size();
    }
    return from;
  }
}
