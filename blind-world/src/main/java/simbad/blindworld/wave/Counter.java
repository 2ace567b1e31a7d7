package simbad.blindworld.wave;

import simbad.blindworld.check.Checks;

/**
 * The timer behind the receiver, as its user reads it.
 *
 * @param soundSpeedMPerS by which a time becomes a range
 * @param lateS how much later than an echo begins it is taken to be detected
 * @param tickS in which times are counted
 * @param resolutionM in which ranges are given; 0 is no rounding
 */
public record Counter(double soundSpeedMPerS, double lateS, double tickS, double resolutionM) {
  /** Refuses what is no such thing. */
  public Counter {
    Checks.positive("speed of sound", soundSpeedMPerS);
    Checks.finite("lateness", lateS);
    Checks.notNegative("tick", tickS);
    Checks.notNegative("resolution", resolutionM);
  }

  /** The range that a time of detection gives before it is rounded, at least 0. */
  public double rangeM(double tS) {
    double counted = tickS > 0 ? Math.floor(tS / tickS) * tickS : tS;
    return Math.max(0, (counted - lateS) * soundSpeedMPerS / 2);
  }

  /** The reading of a range: its step's lower end. */
  public double steppedM(double rangeM) {
    return resolutionM > 0 ? Math.floor(rangeM / resolutionM + 1e-9) * resolutionM : rangeM;
  }
}
