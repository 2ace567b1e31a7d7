package simbad.experiments.cli;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import simbad.demo.Demo;

/** The Simbad window. */
final class DemoWindow {
  private DemoWindow() {}

  /**
   * Opens the window and waits until it is closed.
   *
   * @throws IOException when no window can be opened
   */
  @SuppressWarnings("DoNotCallSuggester")
  static void show(Demo demo) throws IOException {
    if (GraphicsEnvironment.isHeadless()) {
      throw new IOException(
          "there is no display; simbad demo NAME --headless runs a demo without one");
    }
    throw new IOException("no window for " + demo.getClass().getSimpleName() + " so far");
  }
}
