package simbad.blindworld.motion;

/** A change at work in one repeat of a log, with what it remembers. */
public interface Acting {

  /** Alters the speeds of a step; called for each in the order of time. */
  default void move(Step step) {}

  /** Called before the first step of each run, where the robot stands. */
  default void beginRun() {}

  /**
   * By how much earlier the pose was that a frame shows.
   *
   * @param frameS the frame's time on the run's clock
   * @param logShare which share of the log lies before it
   */
  default double agoS(double frameS, double logShare) {
    return 0;
  }

  /** Alters what the tracker sees; called for each frame in the order of time. */
  default void see(Sight sight) {}
}
