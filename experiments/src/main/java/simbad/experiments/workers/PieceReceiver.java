package simbad.experiments.workers;

import java.io.IOException;

/**
 * Takes what comes of the pieces of a job.
 *
 * @param <R> what comes of a piece
 */
@FunctionalInterface
public interface PieceReceiver<R> {
  /**
   * Takes the next piece's result.
   *
   * @param result of the piece after that of the call before
   * @throws IOException if it cannot be kept; no more pieces are done then
   */
  void take(R result) throws IOException;
}
