package simbad.sim;

/**
 * Is told of every simulator of a process and of all its steps; see {@link Simulator#setListener}.
 */
public interface StepListener {
  /**
   * A simulator was made; its agents stand at their start.
   *
   * @param world what it simulates
   */
  void made(Simulator simulator, World world);

  /** A step is asked for. Called by the thread that is to do it; what it throws prevents it. */
  default void stepping(Simulator simulator) {
    // Not of interest to all.
  }

  /** A step was done. Called by the thread that does the steps; what it throws ends them. */
  void stepped(Simulator simulator);
}
