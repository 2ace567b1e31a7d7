package simbad.bench.board;

import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.TableDetection;

/**
 * What stands before the bench's sensor. The sensor is at the origin and looks along +x; to its
 * right is +z.
 *
 * @param target the obstacle; empty for a bench with nothing on it
 * @param distanceM from the sensor to the obstacle's axis, straight ahead, metres, at least 0
 * @param offsetM of the axis to the right, metres
 * @param clockwiseRad how far the obstacle is turned clockwise, seen from above: without offset,
 *     the sensor's bearing
 */
public record BenchScene(
    Optional<BenchTarget> target, double distanceM, double offsetM, double clockwiseRad) {
  /**
   * The bearing 0 of an obstacle that is not turned looks along +z, a quarter turn from the sensor.
   */
  private static final double QUARTER_RAD = Math.PI / 2;

  /** Checks that the numbers are finite, and the distance not below 0. */
  public BenchScene {
    Checks.notNegative("distanceM", distanceM);
    Checks.finite("offsetM", offsetM);
    Checks.finite("clockwiseRad", clockwiseRad);
  }

  /** Returns it as the sonar model takes it. */
  public Scene scene() {
    Placement placement = new Placement(distanceM, offsetM, -clockwiseRad - QUARTER_RAD);
    return new Scene(
        target.stream()
            .map(
                kind ->
                    new Obstacle(
                        "target", placement, kind.outline(), new TableDetection(kind.thresholds())))
            .toList());
  }
}
