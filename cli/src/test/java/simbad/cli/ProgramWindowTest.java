package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.GraphicsEnvironment;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gui.Simbad;

/** Old programs in the window, whoever opens it. */
@Tag("display")
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class ProgramWindowTest {
  @TempDir private Path folder = Path.of("");

  @ParameterizedTest
  @ValueSource(
      strings = {
        "open();",
        "javax.swing.SwingUtilities.invokeLater(() -> open());",
        "new Thread(() -> { try { Thread.sleep(500); } catch (InterruptedException e) { return; }"
            + " open(); }).start();"
      })
  void program_endsWithItsWindow(String main) throws Exception {
    assertFalse(GraphicsEnvironment.isHeadless(), "this test needs a display");
    String title = "window " + main.hashCode();
    Files.writeString(
        folder.resolve("Opens.java"),
        """
        public class Opens {
          static void open() {
            simbad.sim.EnvironmentDescription e = new simbad.sim.EnvironmentDescription();
            e.add(new simbad.sim.Agent(new javax.vecmath.Vector3d(), "robot"));
            new simbad.gui.Simbad(e, false).setTitle("TITLE");
          }
          public static void main(String[] args) {
            MAIN
          }
        }
        """
            .replace("TITLE", title)
            .replace("MAIN", main));
    CompletableFuture<Shell> shell =
        CompletableFuture.supplyAsync(() -> Shell.simbad("program", folder.toString(), "--window"));
    Simbad window = opened(shell, title);
    assertFalse(shell.isDone());
    // Closing it would end the tests: an old program's window ends its process.
    SwingUtilities.invokeAndWait(window::dispose);
    assertEquals(0, shell.get().status(), shell.get().err());
  }

  private static Simbad opened(CompletableFuture<Shell> shell, String title)
      throws InterruptedException {
    while (!shell.isDone()) {
      Simbad window = Simbad.getSimbadInstance();
      if (window != null && window.getTitle().contains(title) && window.isShowing()) {
        return window;
      }
      Thread.sleep(50);
    }
    throw new AssertionError("the command ended: " + shell.join());
  }
}
