package simbad.sonar.change;

import java.util.List;
import java.util.Optional;
import simbad.sonar.ping.ObstacleChange;
import simbad.sonar.ping.SceneChange;
import simbad.sonar.scene.Scene;

/**
 * The thresholds of several obstacles depend on the bearing, of each in its own way.
 *
 * @param each one for each obstacle
 */
public record OrientationShadows(List<OrientationShadow> each)
    implements SceneChange, ObstacleChange {
  /** Copies the list. */
  public OrientationShadows {
    each = List.copyOf(each);
  }

  /** Of several. */
  @Override
  public Optional<String> only() {
    return Optional.empty();
  }

  @Override
  public boolean isIdle(List<String> labels) {
    return each.stream().allMatch(one -> one.isIdle(labels));
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
