package simbad.sonar.ping;

import java.util.Optional;
import simbad.sonar.level.Curve;

/**
 * By how much a near echo is read too far, beside what its level and its bearing say: the sender
 * still rings, and the two pistons look at a near body from two places. A calibration of the
 * set-up, which counts under the level law only.
 *
 * @param addedM metres over the distance to the obstacle's nearest point, metres; 0 from some
 *     distance on
 */
public record NearRange(Curve addedM) implements EarChange {
  @Override
  public Optional<String> only() {
    return Optional.empty();
  }
}
