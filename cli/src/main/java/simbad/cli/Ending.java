package simbad.cli;

import java.util.concurrent.locks.LockSupport;

/**
 * What is to be done should the process be told to end (Ctrl-C) before this is closed.
 *
 * <p>Once the process ends, who closes this or complains goes no further: what was done took away
 * what they work on, and all that they could still say of it is wrong.
 */
final class Ending {
  private final Thread work;

  private Ending(Thread work) {
    this.work = work;
  }

  /**
   * Begins to stand by. Does the work at once, and never returns, where the process ends already.
   *
   * @param work done at most once, in a thread of its own, beside other such work
   */
  static Ending with(Runnable work) {
    Ending ending = new Ending(new Thread(work));
    try {
      Runtime.getRuntime().addShutdownHook(ending.work);
    } catch (IllegalStateException ends) {
      work.run();
      standStill();
    }
    return ending;
  }

  /** Never returns where the process ends. */
  static void goOnUnlessItEnds() {
    Ending.with(() -> {}).close();
  }

  /** The work is no longer to be done. Never returns where the process ends already. */
  void close() {
    try {
      Runtime.getRuntime().removeShutdownHook(work);
    } catch (IllegalStateException ends) {
      standStill();
    }
  }

  private static void standStill() {
    for (; ; ) {
      LockSupport.park();
    }
  }
}
