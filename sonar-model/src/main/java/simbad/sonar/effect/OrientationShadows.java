package simbad.sonar.effect;

import java.util.List;
import simbad.sonar.scene.Scene;

/**
 * The thresholds of several obstacles depend on the bearing, of each in its own way.
 *
 * @param each one for each obstacle
 */
public record OrientationShadows(List<OrientationShadow> each) implements SceneChange {
  /** Copies the list. */
  public OrientationShadows {
    each = List.copyOf(each);
  }

  @Override
  public Scene apply(Scene believed) {
    Scene scene = believed;
    for (OrientationShadow one : each) {
      scene = one.apply(scene);
    }
    return scene;
  }
}
