package simbad.bench.link;

import java.io.IOException;
import java.time.Duration;

/**
 * An open serial line. One thread reads and writes; {@link #close} may come from any thread and
 * ends a read that waits.
 */
public interface SerialLink extends AutoCloseable {
  /**
   * Waits for bytes.
   *
   * @param buffer takes them from its beginning; not empty
   * @param limit how long to wait at most
   * @return how many came, at least 1; 0 when none came in time
   * @throws IOException if the line is closed, or its other end is gone
   */
  int read(byte[] buffer, Duration limit) throws IOException;

  /**
   * Sends bytes, all of them.
   *
   * @throws IOException if the line is closed, its other end is gone, or takes nothing
   */
  void write(byte[] bytes) throws IOException;

  /** Closes it; a second time does nothing. */
  @Override
  void close();
}
