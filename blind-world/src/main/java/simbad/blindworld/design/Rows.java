package simbad.blindworld.design;

import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Row;

/** Rows as they will stand in a file, so that the world hears the poses that are written. */
final class Rows {

  private Rows() {}

  /** A row rounded to a tenth of a millimetre, a thousandth of a degree and a millisecond. */
  static Row row(String run, String sensor, double tS, Pose pose) {
    double degrees = Math.toDegrees(Math.IEEEremainder(pose.headingRad(), 2 * Math.PI));
    return new Row(
        run,
        sensor,
        Math.round(tS * 1e3) / 1e3,
        new Pose(
            Math.round(pose.xM() * 1e4) / 1e4,
            Math.round(pose.zM() * 1e4) / 1e4,
            Math.toRadians(Math.round(degrees * 1e3) / 1e3)));
  }
}
