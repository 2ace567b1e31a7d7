package simbad.kernel.run;

import java.util.concurrent.locks.LockSupport;
import org.jspecify.annotations.Nullable;

/**
 * Repeats a task on a daemon thread of its own. A task that throws ends the repetition; what it
 * threw goes to the thread's handler of uncaught exceptions. Safe for use by several threads.
 */
public final class Pacer {
  private static final double NS_PER_S = 1e9;

  private final String threadName;
  private @Nullable Loop loop;

  /** Creates a pacer that is at rest. */
  public Pacer(String threadName) {
    this.threadName = threadName;
  }

  /**
   * Repeats a task at a fixed rate; what comes late is made up for. Replaces what ran before.
   *
   * @param periodS wall-clock seconds from start to start; 0 or more, 0 repeats without a pause
   * @param task what to do
   */
  public synchronized void start(double periodS, Runnable task) {
    stop();
    Loop started = new Loop(Math.round(periodS * NS_PER_S), task);
    Thread thread = new Thread(started, threadName);
    thread.setDaemon(true);
    thread.start();
    loop = started;
  }

  /** Stops repeating. A task that is under way is finished, but not waited for. */
  public synchronized void stop() {
    if (loop != null) {
      loop.running = false;
      loop = null;
    }
  }

  /** Returns true between start and stop. */
  public synchronized boolean isStarted() {
    return loop != null;
  }

  private static final class Loop implements Runnable {
    private final long periodNs;
    private final Runnable task;
    private volatile boolean running = true;

    Loop(long periodNs, Runnable task) {
      this.periodNs = periodNs;
      this.task = task;
    }

    @Override
    public void run() {
      long dueNs = System.nanoTime();
      while (running) {
        task.run();
        dueNs += periodNs;
        waitUntil(dueNs);
      }
    }

    private void waitUntil(long dueNs) {
      while (running && periodNs > 0 && dueNs - System.nanoTime() > 0) {
        LockSupport.parkNanos(dueNs - System.nanoTime());
      }
    }
  }
}
