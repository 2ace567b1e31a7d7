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
 * @param extent from where to where it reaches over the floor
 */
public record Obstacle(
    String name,
    Placement worldFromObstacle,
    Outline outline,
    Detection detection,
    VerticalExtent extent) {

  /** Creates one without an end above or below. */
  public Obstacle(String name, Placement worldFromObstacle, Outline outline, Detection detection) {
    this(name, worldFromObstacle, outline, detection, VerticalExtent.ENDLESS);
  }

  /** Returns the same in another place. */
  public Obstacle with(Placement place) {
    return new Obstacle(name, place, outline, detection, extent);
  }

  /** Returns the same with another cross-section. */
  public Obstacle with(Outline other) {
    return new Obstacle(name, worldFromObstacle, other, detection, extent);
  }

  /** Returns the same, heard otherwise. */
  public Obstacle with(Detection other) {
    return new Obstacle(name, worldFromObstacle, outline, other, extent);
  }

  /** Returns its cross-section in the world. */
  public Outline worldOutline() {
    return outline.placed(worldFromObstacle);
  }
}
