package simbad.experiments.workers;

import java.io.IOException;
import java.io.Serializable;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;

/**
 * Threads of this process.
 *
 * <p>A piece that is done waits for those before it; so that slow ones do not let results pile up,
 * only so many are begun ahead.
 */
public final class LocalWorkers implements Workers {
  private static final int AHEAD_PER_THREAD = 16;

  private final int ahead;
  private final ExecutorService threads;

  /**
   * Starts threads.
   *
   * @param count at least 1
   */
  public LocalWorkers(int count) {
    ahead = AHEAD_PER_THREAD * count;
    threads =
        Executors.newFixedThreadPool(
            count,
            task -> {
              Thread thread = new Thread(task, "worker");
              thread.setDaemon(true);
              return thread;
            });
  }

  @Override
  public <R extends Serializable> void run(
      Job<R> job, long from, long to, PieceReceiver<? super R> receiver)
      throws IOException, InterruptedException {
    Deque<Future<R>> begun = new ArrayDeque<>();
    try {
      for (long number = from; number < to || !begun.isEmpty(); ) {
        while (number < to && begun.size() < ahead) {
          long piece = number++;
          begun.add(threads.submit(() -> job.piece(piece)));
        }
        receiver.take(result(begun.remove()));
      }
    } finally {
      begun.forEach(future -> future.cancel(true));
    }
  }

  private static <R> R result(Future<R> future) throws InterruptedException {
    try {
      return future.get();
    } catch (ExecutionException e) {
      if (e.getCause() instanceof Error error) {
        throw error;
      }
      throw new IllegalStateException(e.getCause());
    }
  }

  @Override
  public void close() {
    threads.shutdownNow();
  }
}
