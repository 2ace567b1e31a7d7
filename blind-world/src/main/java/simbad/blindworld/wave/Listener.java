package simbad.blindworld.wave;

import simbad.blindworld.world.Pose;

/**
 * A place from which is sent or heard, with the direction in which it looks.
 *
 * @param xM to the right
 * @param zM down the page
 * @param axisX the direction's part along x
 * @param axisZ the direction's part along z
 */
record Listener(double xM, double zM, double axisX, double axisZ) {

  private static final double NEAREST_M = 0.01;

  /** Where a pose is, looking beside its heading by so much. */
  static Listener at(Pose pose, double besideRad) {
    double heading = pose.headingRad() + besideRad;
    return new Listener(pose.xM(), pose.zM(), StrictMath.cos(heading), -StrictMath.sin(heading));
  }

  /** The listener behind a mirror. */
  Listener mirrored(Outline.Face face) {
    double tx = (face.to().xM() - face.from().xM()) / face.lengthM();
    double tz = (face.to().zM() - face.from().zM()) / face.lengthM();
    double dx = xM - face.from().xM();
    double dz = zM - face.from().zM();
    double along = 2 * (dx * tx + dz * tz);
    double turned = 2 * (axisX * tx + axisZ * tz);
    return new Listener(
        face.from().xM() + along * tx - dx,
        face.from().zM() + along * tz - dz,
        turned * tx - axisX,
        turned * tz - axisZ);
  }

  /** The distance to a point, at least a centimetre. */
  double distanceTo(double x, double z) {
    return Math.max(NEAREST_M, Math.sqrt((x - xM) * (x - xM) + (z - zM) * (z - zM)));
  }

  /** The sine of the angle between its axis and a point before it; 1 for what lies behind. */
  double sineTo(double x, double z) {
    double dx = x - xM;
    double dz = z - zM;
    double before = dx * axisX + dz * axisZ;
    return before <= 0 ? 1 : Math.abs(dx * axisZ - dz * axisX) / distanceTo(x, z);
  }
}
