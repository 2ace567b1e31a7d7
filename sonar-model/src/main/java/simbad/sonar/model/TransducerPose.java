package simbad.sonar.model;

import simbad.sonar.sensing.TransducerPoses;

/**
 * One transducer's pose on the plane, copied out of the belt's buffer; reused from ping to ping.
 */
public final class TransducerPose {
  double xM;
  double zM;
  double directionX;
  double directionZ;

  void take(TransducerPoses poses, int transducer) {
    xM = poses.xM(transducer);
    zM = poses.zM(transducer);
    // Seen from above a tilted direction is shorter than 1. A vertical one becomes no direction at
    // all (NaN), which no cone holds anything in.
    double x = poses.directionX(transducer);
    double z = poses.directionZ(transducer);
    double length = Math.sqrt(x * x + z * z);
    directionX = x / length;
    directionZ = z / length;
  }

  /** How far ahead a place is, metres. */
  double alongM(double atXM, double atZM) {
    return (atXM - xM) * directionX + (atZM - zM) * directionZ;
  }

  /** How far from the heading's line a place is, metres, either sign. */
  double acrossM(double atXM, double atZM) {
    return (atXM - xM) * directionZ - (atZM - zM) * directionX;
  }

  /** Creates a pose that is nowhere until it is aimed. */
  public TransducerPose() {}

  /**
   * Puts the transducer at a place and lets it look along a heading.
   *
   * @param atXM metres
   * @param atZM metres
   * @param headingRad radians
   * @return this
   */
  public TransducerPose aim(double atXM, double atZM, double headingRad) {
    return aim(atXM, atZM, Math.cos(headingRad), -Math.sin(headingRad));
  }

  /**
   * Puts the transducer at a place and lets it look in a direction.
   *
   * @param atXM metres
   * @param atZM metres
   * @param newDirectionX of length 1 with the next
   * @param newDirectionZ likewise
   * @return this
   */
  public TransducerPose aim(double atXM, double atZM, double newDirectionX, double newDirectionZ) {
    xM = atXM;
    zM = atZM;
    directionX = newDirectionX;
    directionZ = newDirectionZ;
    return this;
  }
}
