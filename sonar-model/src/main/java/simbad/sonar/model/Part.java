package simbad.sonar.model;

import simbad.sonar.check.Checks;

/**
 * A part of the distribution of a reading: a Gaussian, or evenly spread.
 *
 * @param meanM mean range, metres
 * @param deviationM standard deviation of a Gaussian, metres; 0 for a point
 * @param halfWidthM half the width of an evenly spread part, metres; 0 for a Gaussian
 * @param share its probability, in [0, 1]
 */
public record Part(double meanM, double deviationM, double halfWidthM, double share) {
  /** Refuses what is no number. */
  public Part {
    Checks.number("meanM", meanM);
    Checks.number("deviationM", deviationM);
    Checks.number("halfWidthM", halfWidthM);
    Checks.number("share", share);
  }

  /** The probability that the measured range is below a value. */
  double below(double rangeM) {
    if (halfWidthM > 0) {
      return Math.max(0, Math.min(1, (rangeM - meanM + halfWidthM) / (2 * halfWidthM)));
    }
    return NormalDistribution.cumulative((rangeM - meanM) / deviationM);
  }

  boolean isPoint() {
    return halfWidthM == 0 && !(deviationM > 0);
  }
}
