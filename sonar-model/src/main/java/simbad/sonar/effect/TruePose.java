package simbad.sonar.effect;

/** A sensor's pose on its way from where it is believed to be to where it is. */
public final class TruePose {
  private double xM;
  private double zM;
  private double headingRad;

  /** Puts the pose somewhere. */
  public void set(double newXM, double newZM, double newHeadingRad) {
    xM = newXM;
    zM = newZM;
    headingRad = newHeadingRad;
  }

  /** Turns the heading counter-clockwise by an angle in radians. */
  public void turn(double byRad) {
    headingRad += byRad;
  }

  /** Returns x in metres. */
  public double xM() {
    return xM;
  }

  /** Returns z in metres. */
  public double zM() {
    return zM;
  }

  /** Returns the heading in radians. */
  public double headingRad() {
    return headingRad;
  }
}
