package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import javax.swing.JInternalFrame;
import javax.swing.JTextArea;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.Simulator;
import simbad.sim.World;

/** Old programs lay out windows on their main thread, while the event thread writes into them. */
@Tag("display")
class ForeignLayoutTest {
  @Test
  void inspector_canBeLaidOutByAnotherThread() throws Exception {
    EnvironmentDescription environment = new EnvironmentDescription();
    Agent agent = new Agent(new Vector3d(), "agent");
    environment.add(agent);
    Simulator simulator = new Simulator(null, new World(environment), environment);
    AgentInspector inspector =
        Desk.onEventThread(() -> new AgentInspector(agent, false, simulator));
    checkLayout(inspector, inspector::update);
  }

  @Test
  void console_canBeLaidOutByAnotherThread() throws Exception {
    Console console = Desk.onEventThread(() -> new Console(300, 200));
    checkLayout(console, () -> System.out.println("news"));
  }

  /** Measures the text while this thread lays out and the event thread has news to write. */
  private static void checkLayout(JInternalFrame frame, Runnable news) throws Exception {
    JTextArea text = Desk.parts(frame, JTextArea.class).findFirst().orElseThrow();
    synchronized (frame.getTreeLock()) {
      news.run();
      Desk.await("the text is written", ForeignLayoutTest::isEventThreadBlocked);
      CompletableFuture<?> measured = CompletableFuture.runAsync(text::getPreferredSize);
      measured.get(10, TimeUnit.SECONDS);
      assertTrue(
          isEventThreadBlocked(), "the event thread waits for this one, not this one for it");
    }
    Desk.onEventThread(
        () -> {
          frame.dispose();
          return true;
        });
  }

  /** Without a window Java ends an idle event thread, and starts another one when it needs one. */
  private static boolean isEventThreadBlocked() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().startsWith("AWT-EventQueue"))
        .anyMatch(thread -> thread.getState() == Thread.State.BLOCKED);
  }
}
