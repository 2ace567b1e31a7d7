package simbad.experiments.control;

/** Velocities for one step, in a buffer that the controller fills anew. */
public final class Command {
  private double speedMPerS;
  private double turnRateRadPerS;

  /**
   * Sets both velocities.
   *
   * @param speed ahead, metres per second
   * @param turnRate counter-clockwise, radians per second
   */
  public void set(double speed, double turnRate) {
    speedMPerS = speed;
    turnRateRadPerS = turnRate;
  }

  /** Returns the speed ahead in metres per second. */
  public double speedMPerS() {
    return speedMPerS;
  }

  /** Returns the turn rate in radians per second, counter-clockwise positive. */
  public double turnRateRadPerS() {
    return turnRateRadPerS;
  }
}
