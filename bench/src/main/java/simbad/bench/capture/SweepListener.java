package simbad.bench.capture;

/** Is told how a sweep goes on. Called by the thread that runs it. */
@FunctionalInterface
public interface SweepListener {
  /**
   * A bearing is done.
   *
   * @param bearing index in the plan
   * @param fit what came of it
   * @param state of the sweep with it
   */
  void done(int bearing, ThresholdFit fit, SweepState state);
}
