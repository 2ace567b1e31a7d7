package simbad.sonar.ping;

import java.util.Optional;
import simbad.sonar.frame.Angles;
import simbad.sonar.level.Curve;

/**
 * By how much the echo of an obstacle comes from beyond its nearest point, by the bearing of the
 * sensor: an edge is nearest, but a flat side or a corner behind it answers. A calibration of the
 * set-up, which counts under the level law only.
 *
 * @param only label of the obstacle; empty for all
 * @param addedM metres over the bearing in the obstacle's frame, radians in [0, 2 pi]
 * @param deviationM how far that may be off, over the same; nowhere below 0
 */
public record EchoPath(Optional<String> only, Curve addedM, Curve deviationM) implements EarChange {
  /** Returns a curve round an obstacle through values at even bearings from 0 on. */
  public static Curve round(double... values) {
    double[] points = new double[2 * values.length + 2];
    for (int i = 0; i <= values.length; i++) {
      points[2 * i] = i * Angles.TURN_RAD / values.length;
      points[2 * i + 1] = values[i % values.length];
    }
    return Curve.of(points);
  }
}
