package simbad.bench.link;

import java.io.IOException;

/** Opens a line, as often as it is lost. */
@FunctionalInterface
public interface LinkSource {
  /**
   * Opens the line anew.
   *
   * @throws IOException if it cannot be opened, in one line that says why and names the port
   */
  SerialLink open() throws IOException;
}
