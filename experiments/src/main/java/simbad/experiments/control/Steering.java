package simbad.experiments.control;

/** Follows an edge by one bit, whether anything is heard. */
interface Steering {
  /**
   * Decides the next step.
   *
   * @param heard whether any transducer hears an echo
   * @param odometry where the robot believes to be, before the step
   * @param command receives the velocities
   */
  void steer(boolean heard, Odometry odometry, Command command);

  /** Tells whether another steering should take over from here. */
  default boolean isOver() {
    return false;
  }
}
