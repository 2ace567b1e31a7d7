package simbad.sonar.effect;

import simbad.sonar.scene.Scene;

/**
 * An obstacle is turned otherwise than believed.
 *
 * @param turnRad counter-clockwise seen from above; 0 is neutral
 * @param obstacle index of the one that is, {@link #EVERY} for all
 */
public record ObstacleTurn(double turnRad, int obstacle) implements SceneChange {
  /** In the place of an obstacle's index: all of them. */
  public static final int EVERY = -1;

  @Override
  public Scene apply(Scene believed) {
    return Scenes.placed(believed, obstacle, place -> place.turned(turnRad));
  }
}
