package simbad.sim;

/** A lock that one thread at a time can hold. Not reentrant: who locks twice waits for itself. */
public class Lock {
  private boolean locked;

  Lock() {}

  /** Waits until the lock is free and takes it. */
  public synchronized void lock() {
    boolean interrupted = false;
    while (locked) {
      try {
        wait();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    locked = true;
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  /** Frees the lock. */
  public synchronized void unlock() {
    locked = false;
    notifyAll();
  }
}
