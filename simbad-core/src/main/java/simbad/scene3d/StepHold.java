package simbad.scene3d;

/** Keeps steps away while a scene copies what it shows. */
public interface StepHold {
  /**
   * Waits until no step is under way and holds further ones.
   *
   * @return false if that took too long; then nothing is held
   */
  boolean take();

  /** Lets steps go on; called after each {@link #take()} that returned true. */
  void release();
}
