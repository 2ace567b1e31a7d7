package simbad.kernel.motion;

/**
 * Decides in which simulation steps a device is updated.
 *
 * <p>The first step always updates. That update is paid for like any other, so the time account is
 * overdrawn and the second update comes about twice as late: three per second at 0.05 s per step
 * gives steps 1 and 14, then every sixth or seventh.
 */
public final class UpdateClock {
  private double ratePerS = 1;
  private double periodS = 1;
  private double accountS;
  private boolean started;
  private boolean eachStep;

  /** Creates a clock that updates once per second. */
  public UpdateClock() {}

  /**
   * Sets the rate of updates.
   *
   * @param updatesPerS per second; 0 updates in the first step only
   */
  public void setRate(double updatesPerS) {
    if (!(updatesPerS >= 0)) {
      throw new IllegalArgumentException(
          "updatesPerS = " + updatesPerS + " is not in [0, infinity)");
    }
    ratePerS = updatesPerS;
    periodS = 1 / updatesPerS;
  }

  /** Returns the rate of updates, per second. */
  public double ratePerS() {
    return ratePerS;
  }

  /**
   * Lets the next step update, whatever the time account says.
   *
   * @param keepPhase whether the time account stays as it is; if not, all is as at the start
   */
  public void restart(boolean keepPhase) {
    started = false;
    accountS = keepPhase ? accountS : 0;
  }

  /** Returns true if a restart that keeps the phase is other than one that does not. */
  public boolean hasPhase() {
    return accountS != 0 && !eachStep;
  }

  /** Updates in every step, or at the rate. */
  public void setEachStep(boolean newEachStep) {
    eachStep = newEachStep;
  }

  /**
   * Lets a step pass.
   *
   * @param durationS how long the step takes in simulated seconds
   * @return true if the device is to be updated in this step
   */
  public boolean tick(double durationS) {
    if (eachStep) {
      return true;
    }
    accountS += durationS;
    if (started && !(accountS > periodS)) {
      return false;
    }
    started = true;
    accountS -= periodS;
    return true;
  }
}
