package simbad.experiments.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.GraphicsEnvironment;
import java.awt.event.WindowEvent;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.gui.Simbad;

/** The commands that open the window, on a display. */
@Tag("display")
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class DemoWindowTest {
  @ParameterizedTest
  @CsvSource({
    "view, BaseDemo",
    "demo angle, AngleDemo",
    "view AvoidersDemo, AvoidersDemo",
    "view imager, ImagerDemo"
  })
  void command_endsWithItsWindow(String command, String title) throws Exception {
    assertFalse(GraphicsEnvironment.isHeadless(), "this test needs a display");
    CompletableFuture<Shell> shell =
        CompletableFuture.supplyAsync(() -> Shell.simbad(command.split(" ", -1)));
    Simbad window = opened(shell);
    assertTrue(window.getTitle().contains(title), window.getTitle());
    assertFalse(shell.isDone());
    SwingUtilities.invokeAndWait(
        () -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING)));
    assertEquals(new Shell(0, "", ""), shell.get());
  }

  /** Waits until the command has made the window its own: closing it before would end the tests. */
  private static Simbad opened(CompletableFuture<Shell> shell) throws InterruptedException {
    while (!shell.isDone()) {
      Simbad window = Simbad.getSimbadInstance();
      if (window != null
          && window.isShowing()
          && window.getDefaultCloseOperation() == Simbad.DISPOSE_ON_CLOSE) {
        return window;
      }
      Thread.sleep(50);
    }
    throw new AssertionError("the command ended: " + shell.join());
  }
}
