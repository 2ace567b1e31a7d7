package simbad.blindworld.motion;

/** A pose as a tracker sees it, before its scatter. Headings are not wrapped. */
public final class Sight {

  private double x;
  private double z;
  private double heading;

  void set(double xM, double zM, double headingRad) {
    x = xM;
    z = zM;
    heading = headingRad;
  }

  /** Where the tracked point is. */
  public double xM() {
    return x;
  }

  /** Where the tracked point is. */
  public double zM() {
    return z;
  }

  /** The heading. */
  public double headingRad() {
    return heading;
  }

  /** Another point. */
  public void moveTo(double xM, double zM) {
    x = xM;
    z = zM;
  }

  /** A point beside this one, in the frame of the heading. */
  public void shift(double forwardM, double leftM) {
    double cos = StrictMath.cos(heading);
    double sin = StrictMath.sin(heading);
    x += forwardM * cos - leftM * sin;
    z += -forwardM * sin - leftM * cos;
  }

  /** Another heading. */
  public void turn(double byRad) {
    heading += byRad;
  }
}
