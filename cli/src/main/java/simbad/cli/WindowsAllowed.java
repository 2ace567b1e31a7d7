package simbad.cli;

import java.io.IOException;
import simbad.cli.machine.Launcher;
import simbad.cli.machine.Purpose;

/**
 * Whether this process may open windows. Java decides when it loads its first picture, and keeps to
 * it: a command that opens one must ask before.
 */
final class WindowsAllowed {
  private static final String HEADLESS = "java.awt.headless";

  private static boolean forbidden;

  private WindowsAllowed() {}

  /** For the begin of the process: pictures are drawn without a display, whatever it has. */
  static synchronized void noneUnlessAsked() {
    if (System.getProperty(HEADLESS) == null) {
      System.setProperty(HEADLESS, "true");
      forbidden = true;
    }
  }

  /**
   * For a command that opens one, before all else: what is missing for it is installed where the
   * launcher may. Who started Java without windows keeps them out.
   *
   * @throws IOException if it cannot be installed
   */
  static synchronized void ask() throws IOException, InterruptedException {
    Launcher.need(Purpose.WINDOW);
    if (forbidden) {
      System.clearProperty(HEADLESS);
      forbidden = false;
    }
  }
}
