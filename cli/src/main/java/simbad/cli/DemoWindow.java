package simbad.cli;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import javax.swing.WindowConstants;
import simbad.demo.Demo;
import simbad.gui.Simbad;

/** The Simbad window. */
final class DemoWindow {
  private DemoWindow() {}

  /**
   * Opens the window and waits until it is closed.
   *
   * @throws IOException when there is no display
   */
  static void show(Demo demo) throws IOException, InterruptedException {
    open(demo).awaitClosed();
  }

  /** The same with a demo that runs from the beginning. */
  static void showRunning(Demo demo) throws IOException, InterruptedException {
    Simbad window = open(demo);
    window.startSimulation();
    window.awaitClosed();
  }

  private static Simbad open(Demo demo) throws IOException {
    if (GraphicsEnvironment.isHeadless()) {
      throw new IOException(
          "there is no display; simbad demo NAME --headless runs a demo without one");
    }
    Simbad window = new Simbad(demo, false);
    // The command ends when the window is closed, not the process: exit statuses are the command's.
    window.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
    return window;
  }
}
