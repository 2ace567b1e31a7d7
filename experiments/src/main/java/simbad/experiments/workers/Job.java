package simbad.experiments.workers;

import java.io.Serializable;

/**
 * Work that is cut into numbered pieces, none of which depends on another.
 *
 * <p>It may be sent to another machine: it holds all that it needs, files included. Thread-safe.
 *
 * @param <R> what comes of a piece
 */
public interface Job<R extends Serializable> extends Serializable {
  /**
   * Does one piece; done twice it comes to the same. A piece that fails says so in its result: what
   * is thrown ends the whole job.
   *
   * @param number of the piece
   */
  R piece(long number);
}
