package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.GraphicsEnvironment;
import java.awt.event.WindowEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JButton;
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
    "view, AngleDemo, pause",
    "demo angle, AngleDemo, run",
    "view imager, ImagerDemo, pause"
  })
  void command_endsWithItsWindow(String command, String title, String next) throws Exception {
    assertFalse(GraphicsEnvironment.isHeadless(), "this test needs a display");
    CompletableFuture<Shell> shell =
        CompletableFuture.supplyAsync(() -> Shell.simbad(command.split(" ", -1)));
    Simbad window = opened(shell);
    assertTrue(window.getTitle().contains(title), window.getTitle());
    while (!enabled(window).contains(next)) {
      Thread.sleep(50);
    }
    assertFalse(shell.isDone());
    SwingUtilities.invokeAndWait(
        () -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING)));
    assertEquals(new Shell(0, "", ""), shell.get());
  }

  /** What can be pressed: "run" while the simulation waits, "pause" while it runs. */
  private static List<String> enabled(Simbad window) throws Exception {
    List<String> texts = new ArrayList<>();
    SwingUtilities.invokeAndWait(() -> collect(window.getDesktopPane(), texts));
    return texts;
  }

  private static void collect(Container container, List<String> texts) {
    for (Component part : container.getComponents()) {
      if (part instanceof JButton button && button.isEnabled() && button.getText() != null) {
        texts.add(button.getText());
      } else if (part instanceof Container inner) {
        collect(inner, texts);
      }
    }
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
