package simbad.sonar.effect;

import simbad.sonar.scene.Scene;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.shape.ThresholdTable;

/**
 * The threshold depends on the bearing, while the simulator believes it uniform.
 *
 * @param obstacle index of the one whose it does, {@link #EVERY} for all
 * @param table its thresholds
 */
public record OrientationShadow(int obstacle, ThresholdTable table) implements SceneChange {
  /** In the place of an obstacle's index: all of them. */
  public static final int EVERY = -1;

  @Override
  public Scene apply(Scene believed) {
    return Scenes.detected(believed, obstacle, any -> new TableDetection(table));
  }
}
