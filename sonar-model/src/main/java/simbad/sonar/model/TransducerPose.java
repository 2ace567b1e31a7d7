package simbad.sonar.model;

import simbad.sonar.sensing.TransducerPoses;

/**
 * One transducer's pose on the plane, copied out of the belt's buffer; reused from ping to ping.
 */
final class TransducerPose {
  double xM;
  double zM;
  double directionX;
  double directionZ;

  void take(TransducerPoses poses, int transducer) {
    xM = poses.xM(transducer);
    zM = poses.zM(transducer);
    directionX = poses.directionX(transducer);
    directionZ = poses.directionZ(transducer);
  }

  TransducerPose aim(double atXM, double atZM, double headingRad) {
    xM = atXM;
    zM = atZM;
    directionX = Math.cos(headingRad);
    directionZ = -Math.sin(headingRad);
    return this;
  }
}
