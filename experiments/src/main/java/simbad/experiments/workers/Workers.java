package simbad.experiments.workers;

import java.io.IOException;
import java.io.Serializable;

/** Does the pieces of jobs, several at a time. */
public interface Workers extends AutoCloseable {
  /**
   * Does pieces of a job.
   *
   * @param job to do
   * @param from the first piece's number, at least 0
   * @param to one more than the last piece's number; from itself for none
   * @param receiver takes every piece's result once, in the order of their numbers, in the calling
   *     thread
   * @throws IOException if the receiver threw it, or the workers are gone
   * @throws InterruptedException if the calling thread was interrupted
   */
  <R extends Serializable> void run(
      Job<R> job, long from, long to, PieceReceiver<? super R> receiver)
      throws IOException, InterruptedException;

  @Override
  void close();
}
