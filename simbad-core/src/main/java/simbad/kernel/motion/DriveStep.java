package simbad.kernel.motion;

/**
 * The displacement of one step in the frame that the robot had when the step began. A mutable
 * buffer; not safe for use by several threads.
 */
public final class DriveStep {
  private double forwardM;
  private double leftM;
  private double turnRad;

  /** Creates a step that stays where it is. */
  public DriveStep() {}

  /**
   * Sets the displacement.
   *
   * @param newForwardM metres along the heading
   * @param newLeftM metres to the left of it
   * @param newTurnRad turn in radians, counter-clockwise from above
   */
  public void set(double newForwardM, double newLeftM, double newTurnRad) {
    forwardM = newForwardM;
    leftM = newLeftM;
    turnRad = newTurnRad;
  }

  /** Returns the metres along the heading. */
  public double forwardM() {
    return forwardM;
  }

  /** Returns the metres to the left of the heading. */
  public double leftM() {
    return leftM;
  }

  /** Returns the turn in radians, counter-clockwise from above. */
  public double turnRad() {
    return turnRad;
  }
}
