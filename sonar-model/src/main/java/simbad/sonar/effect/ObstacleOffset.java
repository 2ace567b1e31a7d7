package simbad.sonar.effect;

import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.scene.Scene;

/**
 * An obstacle stands elsewhere than believed.
 *
 * @param xM by how much, metres; 0 is neutral
 * @param zM by how much, metres; 0 is neutral
 * @param only label of the one obstacle that does; empty for all
 */
public record ObstacleOffset(double xM, double zM, Optional<String> only)
    implements SceneChange, ObstacleChange {
  /** Checks the figures; NaN is refused. */
  public ObstacleOffset {
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
  }

  @Override
  public Scene apply(Scene believed) {
    return Scenes.placed(believed, only, place -> place.moved(xM, zM));
  }
}
