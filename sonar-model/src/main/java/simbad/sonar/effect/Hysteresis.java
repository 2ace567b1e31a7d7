package simbad.sonar.effect;

/**
 * An obstacle is picked up at a shorter distance than it is lost at.
 *
 * @param pickUpFactor of the threshold after a miss; 1 is neutral
 * @param holdFactor of the threshold after an echo; 1 is neutral
 */
public record Hysteresis(double pickUpFactor, double holdFactor) implements MemoryChange {
  @Override
  public boolean isNeutral() {
    return pickUpFactor == 1 && holdFactor == 1;
  }

  double factor(boolean heardBefore) {
    return heardBefore ? holdFactor : pickUpFactor;
  }
}
