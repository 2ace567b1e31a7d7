package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * An obstacle is picked up at a shorter distance than it is lost at.
 *
 * @param pickUpFactor of the threshold after a miss; 1 is neutral
 * @param holdFactor of the threshold after an echo; 1 is neutral
 * @param pickUpM what the threshold is shorter by after a miss, metres; 0 is neutral
 */
public record Hysteresis(double pickUpFactor, double holdFactor, double pickUpM)
    implements MemoryChange {
  /** Checks the figures; NaN is refused. */
  public Hysteresis {
    Checks.notNegative("pickUpFactor", pickUpFactor);
    Checks.notNegative("holdFactor", holdFactor);
    Checks.finite("pickUpM", pickUpM);
  }

  /** Creates one in proportion to the threshold. */
  public Hysteresis(double pickUpFactor, double holdFactor) {
    this(pickUpFactor, holdFactor, 0);
  }

  @Override
  public boolean isNeutral() {
    return pickUpFactor == 1 && holdFactor == 1 && pickUpM == 0;
  }

  double thresholdM(double thresholdM, boolean heardBefore) {
    return heardBefore ? thresholdM * holdFactor : thresholdM * pickUpFactor - pickUpM;
  }
}
