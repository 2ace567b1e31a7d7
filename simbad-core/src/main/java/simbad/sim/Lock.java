package simbad.sim;

import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;

/**
 * A lock that one thread at a time can hold. Not reentrant: who locks twice waits for itself. Who
 * waits longest gets it first, so that steps without a pause leave others their turn.
 */
public class Lock {
  private final Semaphore free = new Semaphore(1, true);

  Lock() {}

  /** Waits until the lock is free and takes it. */
  public void lock() {
    free.acquireUninterruptibly();
  }

  /** Waits for some time until the lock is free and takes it; returns false if it stayed taken. */
  boolean lockWithin(long milliseconds) {
    try {
      return free.tryAcquire(milliseconds, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  /** Frees the lock; a lock that is free stays so. */
  public void unlock() {
    if (free.availablePermits() == 0) {
      free.release();
    }
  }
}
