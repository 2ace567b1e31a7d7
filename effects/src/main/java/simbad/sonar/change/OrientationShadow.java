package simbad.sonar.change;

import java.util.Arrays;
import java.util.Optional;
import simbad.sonar.ping.ObstacleChange;
import simbad.sonar.ping.SceneChange;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.shape.ThresholdTable;

/**
 * The threshold depends on the bearing, while the simulator believes it uniform.
 *
 * @param only label of the one obstacle whose it does; empty for all
 * @param table its thresholds
 */
public record OrientationShadow(Optional<String> only, ThresholdTable table)
    implements SceneChange, ObstacleChange {
  @Override
  public Scene apply(Scene believed) {
    return Scenes.detected(believed, only, this::seen);
  }

  /** A polygon runs inside its circle: a table of the believed value all round changes nothing. */
  private Detection seen(Detection detection) {
    double uniform = detection.greatestM();
    boolean flat = Arrays.stream(table.valuesM()).allMatch(value -> value == uniform);
    return flat ? detection : new TableDetection(table);
  }
}
