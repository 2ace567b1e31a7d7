package simbad.bench.capture;

import java.io.IOException;
import simbad.bench.protocol.FrameLine;

/** Gives one reading after the other. */
@FunctionalInterface
public interface PingSource {
  /**
   * Pings.
   *
   * @return a ping that was triggered after the call began
   * @throws IOException if there will be none
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  FrameLine.Ping ping() throws IOException, InterruptedException;
}
