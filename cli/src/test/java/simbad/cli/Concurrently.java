package simbad.cli;

import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/** Several checks at the same time. */
final class Concurrently {
  private Concurrently() {}

  /** Returns when all are done; throws what one of them threw. */
  static void run(List<Callable<Void>> checks) throws Exception {
    ExecutorService threads = Executors.newFixedThreadPool(checks.size());
    try {
      for (Future<Void> check : threads.invokeAll(checks)) {
        check.get();
      }
    } finally {
      threads.shutdownNow();
    }
  }
}
