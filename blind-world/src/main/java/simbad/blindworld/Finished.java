package simbad.blindworld;

import java.io.PrintStream;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.IntConsumer;
import simbad.blindworld.file.FormatException;

/** Says how many of the cases are drawn, now and then. For use by several threads. */
final class Finished implements IntConsumer {
  /** The option that says after how many. */
  static final String OPTION = "--progress";

  private static final int STEP = 25;

  private final AtomicInteger finished = new AtomicInteger();
  private final int cases;
  private final int step;
  private final PrintStream err;

  /**
   * Of some cases.
   *
   * @param options of the call
   * @param cases how many there will be
   * @param err told after each so many of them, and at the end
   */
  Finished(Options options, int cases, PrintStream err) throws FormatException {
    this.cases = cases;
    this.err = err;
    step = (int) options.number(OPTION, STEP, 1, 1e6);
  }

  @Override
  public void accept(int number) {
    int count = finished.incrementAndGet();
    if (count % step == 0 || count == cases) {
      err.println("generated " + count + " of " + cases);
    }
  }
}
