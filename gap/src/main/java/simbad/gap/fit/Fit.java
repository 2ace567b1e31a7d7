package simbad.gap.fit;

import simbad.sonar.check.Checks;

/**
 * A hypothesis with the values that fit best.
 *
 * @param hypothesis with its values
 * @param logLikelihood of the pings that counted, natural
 */
public record Fit(Hypothesis hypothesis, double logLikelihood) {
  /** Refuses what is no number. */
  public Fit {
    Checks.number("logLikelihood", logLikelihood);
  }
}
