package simbad.sonar.effect;

import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.scene.Scene;

/**
 * An obstacle is turned otherwise than believed.
 *
 * @param turnRad counter-clockwise seen from above; 0 is neutral
 * @param only label of the one obstacle that is; empty for all
 */
public record ObstacleTurn(double turnRad, Optional<String> only)
    implements SceneChange, ObstacleChange {
  /** Checks the figure; NaN is refused. */
  public ObstacleTurn {
    Checks.finite("turnRad", turnRad);
  }

  @Override
  public Scene apply(Scene believed) {
    return Scenes.placed(believed, only, place -> place.turned(turnRad));
  }
}
