package simbad.sonar.ping;

import simbad.sonar.frame.Angles;

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

  /** Puts the pose where another one is. */
  public void set(TruePose other) {
    set(other.xM, other.zM, other.headingRad);
  }

  /** Puts the pose on the way from one to another, turned the shorter way. */
  public void setBetween(TruePose from, TruePose to, double share) {
    double turn = Angles.signed(to.headingRad - from.headingRad);
    set(
        from.xM + share * (to.xM - from.xM),
        from.zM + share * (to.zM - from.zM),
        from.headingRad + share * turn);
  }

  /** Returns a copy. */
  public TruePose copy() {
    TruePose copy = new TruePose();
    copy.set(this);
    return copy;
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
