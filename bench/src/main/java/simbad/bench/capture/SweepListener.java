package simbad.bench.capture;

/** Is told how a sweep goes on. Called by the thread that runs it. */
public interface SweepListener {
  /**
   * A reading was recorded.
   *
   * @param taken what was recorded
   * @param state of the sweep with it
   */
  default void taken(Entry.Taken taken, SweepState state) {}

  /**
   * A bearing is done.
   *
   * @param bearing index in the plan
   * @param fit what came of it
   * @param state of the sweep with it
   */
  default void done(int bearing, ThresholdFit fit, SweepState state) {}
}
