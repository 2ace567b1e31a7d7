package simbad.sonar.effect;

import simbad.sonar.scene.Scene;

/**
 * An obstacle stands elsewhere than believed.
 *
 * @param xM by how much, metres; 0 is neutral
 * @param zM by how much, metres; 0 is neutral
 * @param obstacle index of the one that does, {@link #EVERY} for all
 */
public record ObstacleOffset(double xM, double zM, int obstacle) implements SceneChange {
  /** In the place of an obstacle's index: all of them. */
  public static final int EVERY = -1;

  @Override
  public Scene apply(Scene believed) {
    return Scenes.placed(believed, obstacle, place -> place.moved(xM, zM));
  }
}
