package simbad.kernel.motion;

/**
 * Two driven wheels on one axle. A step follows the exact arc about the centre of curvature; wheel
 * speeds that differ by less than 1 mm/s count as straight, with the left wheel's speed.
 */
public final class DifferentialDrive {
  private static final double STRAIGHT_M_PER_S = 0.001;

  private final double wheelDistanceM;
  private double leftMPerS;
  private double rightMPerS;

  /**
   * Creates a drive at rest.
   *
   * @param wheelDistanceM distance between the wheels in metres; above 0
   */
  public DifferentialDrive(double wheelDistanceM) {
    if (!(wheelDistanceM > 0)) {
      throw new IllegalArgumentException(
          "wheelDistanceM = " + wheelDistanceM + " is not in (0, infinity)");
    }
    this.wheelDistanceM = wheelDistanceM;
  }

  /** Stops both wheels. */
  public void stop() {
    leftMPerS = 0;
    rightMPerS = 0;
  }

  /** Sets the left wheel's speed over ground in metres per second. */
  public void setLeft(double newLeftMPerS) {
    leftMPerS = newLeftMPerS;
  }

  /** Sets the right wheel's speed over ground in metres per second. */
  public void setRight(double newRightMPerS) {
    rightMPerS = newRightMPerS;
  }

  /** Returns the left wheel's speed in metres per second. */
  public double leftMPerS() {
    return leftMPerS;
  }

  /** Returns the right wheel's speed in metres per second. */
  public double rightMPerS() {
    return rightMPerS;
  }

  /** Computes the displacement of a step that takes the given time in seconds. */
  public void advance(double durationS, DriveStep step) {
    double difference = rightMPerS - leftMPerS;
    if (Math.abs(difference) < STRAIGHT_M_PER_S) {
      step.set(leftMPerS * durationS, 0, 0);
      return;
    }
    double turnRad = difference * durationS / wheelDistanceM;
    double radiusM = wheelDistanceM * (leftMPerS + rightMPerS) / (2 * difference);
    step.set(radiusM * Math.sin(turnRad), radiusM * (1 - Math.cos(turnRad)), turnRad);
  }
}
