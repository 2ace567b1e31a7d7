package simbad.kernel.motion;

/**
 * A drive that is told how fast the body shall go and turn. A step goes straight along the heading
 * that it began with and turns afterwards (explicit Euler); speeds stay until they are changed.
 */
public final class BodyDrive {
  private double speedMPerS;
  private double turnRadPerS;

  /** Creates a drive at rest. */
  public BodyDrive() {}

  /** Stops. */
  public void stop() {
    speedMPerS = 0;
    turnRadPerS = 0;
  }

  /** Sets the speed along the heading, in metres per second. */
  public void setSpeed(double newSpeedMPerS) {
    speedMPerS = newSpeedMPerS;
  }

  /** Sets the turning rate in radians per second, counter-clockwise. */
  public void setTurn(double newTurnRadPerS) {
    turnRadPerS = newTurnRadPerS;
  }

  /** Returns the speed along the heading, in metres per second. */
  public double speedMPerS() {
    return speedMPerS;
  }

  /** Returns the turning rate in radians per second. */
  public double turnRadPerS() {
    return turnRadPerS;
  }

  /** Computes the displacement of a step that takes the given time in seconds. */
  public void advance(double durationS, DriveStep step) {
    step.set(speedMPerS * durationS, 0, turnRadPerS * durationS);
  }
}
