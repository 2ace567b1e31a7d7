package simbad.sonar.ping;

import java.util.Optional;

/**
 * Near an obstacle its echo comes from where it adds up, not from its nearest point: a calibration
 * of the set-up, which counts under the level law only.
 *
 * @param only label of the obstacle; empty for all
 * @param field its near field; empty leaves all as it is
 */
public record NearEcho(Optional<String> only, Optional<NearField> field)
    implements LevelChange, ObstacleChange {
  @Override
  public boolean changesGeometry() {
    return true;
  }

  /** It is what the ears know, and adds nothing to it. */
  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return 0;
  }
}
