package simbad.sonar.scene;

import simbad.sonar.frame.Placement;
import simbad.sonar.shape.Outline;

/**
 * An obstacle in a scene.
 *
 * @param name free text
 * @param worldFromObstacle where it stands and how it is turned
 * @param outline its cross-section in its own frame
 * @param detection at which distances it is lost
 */
public record Obstacle(
    String name, Placement worldFromObstacle, Outline outline, Detection detection) {

  /** Returns its cross-section in the world. */
  public Outline worldOutline() {
    return outline.placed(worldFromObstacle);
  }
}
