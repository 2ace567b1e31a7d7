package simbad.sonar.effect;

import simbad.sonar.scene.Scene;

/** The obstacles are not as they are believed to be. */
@FunctionalInterface
public non-sealed interface SceneChange extends Change {
  @Override
  default boolean changesGeometry() {
    return true;
  }

  /** Returns the scene as it is. */
  Scene apply(Scene believed);
}
