package simbad.experiments.fleet;

import java.util.Optional;
import simbad.experiments.run.EdgeKept;
import simbad.sonar.frame.Angles;
import simbad.sonar.shape.DetectionShadow;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * What a robot's step is worth that shall go round an obstacle on the edge of its shadow: the share
 * of a turn that it made counter-clockwise, if it is within {@value EdgeKept#NEAR_M} m of the edge.
 * A whole round is worth 1.
 */
final class EdgeGain {
  private final Optional<Outline> edge;
  private double bearingRad;
  private double distanceM;

  EdgeGain(ThresholdTable table) {
    edge = new DetectionShadow(table).edge();
  }

  /** Begins at a place. */
  void start(double xM, double zM) {
    bearingRad = Math.atan2(xM, zM);
    distanceM = edge.map(line -> line.distanceM(xM, zM)).orElse(Double.POSITIVE_INFINITY);
  }

  /** Returns what it is worth to have come to a place. */
  double moved(double xM, double zM) {
    double before = bearingRad;
    start(xM, zM);
    return distanceM <= EdgeKept.NEAR_M ? Angles.signed(bearingRad - before) / Angles.TURN_RAD : 0;
  }

  /** Returns the distance from the edge to the latest place, metres; infinite without an edge. */
  double distanceM() {
    return distanceM;
  }
}
