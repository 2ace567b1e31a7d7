package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** How the window's threads and the stepping thread get on with one another. */
class SteppingThreadTest {
  private static final long PATIENCE_MS = 30_000;

  private final Semaphore steps = new Semaphore(0);
  private final Agent agent =
      new Agent(new Vector3d(), "robot") {
        @Override
        protected void performBehavior() {
          steps.release();
        }
      };
  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final World world = world();
  private final JComponent application = new JPanel();
  private final KeyInputSensor keys = RobotFactory.addKeyInputSensor(agent);
  private final Simulator simulator = new Simulator(application, world, environment);

  private World world() {
    environment.add(agent);
    return new World(environment);
  }

  @AfterEach
  void stop() {
    simulator.dispose();
  }

  private void awaitSteps(int count) throws InterruptedException {
    assertTrue(steps.tryAcquire(count, PATIENCE_MS, TimeUnit.MILLISECONDS));
  }

  @Test
  void isRunning_betweenStartAndStop() {
    assertFalse(simulator.isRunning());
    simulator.startSimulation();
    assertTrue(simulator.isRunning());
    simulator.stopSimulation();
    assertFalse(simulator.isRunning());
  }

  /** Once a second at first: without the new factor the test would run out of patience. */
  @Test
  void timeFactor_countsWhileRunning() throws InterruptedException {
    simulator.setVirtualTimeFactor(1e-6f);
    simulator.startSimulation();
    simulator.setVirtualTimeFactor(1000);
    awaitSteps(100);
  }

  @Test
  void timeFactor_startsNothing() {
    simulator.setVirtualTimeFactor(5);
    assertFalse(simulator.isRunning());
    simulator.startBackgroundMode();
    simulator.setVirtualTimeFactor(1e-6f);
    simulator.stopBackgroundMode();
    simulator.setVirtualTimeFactor(5);
    assertFalse(simulator.isRunning());
  }

  /** Steps without a pause let whoever waits for the lock have it: a hundred times in a row. */
  @Test
  void lock_isGotBetweenSteps() throws InterruptedException {
    simulator.startBackgroundMode();
    awaitSteps(1);
    for (int i = 0; i < 100; i++) {
      assertTrue(world.stepLock().lockWithin(PATIENCE_MS));
      world.stepLock().unlock();
    }
  }

  @Test
  void lock_thatIsHeld_isWaitedForInVain() {
    simulator.lock();
    assertFalse(world.stepLock().lockWithin(1));
    simulator.unlock();
    simulator.unlock();
    assertTrue(world.stepLock().lockWithin(1));
    assertFalse(world.stepLock().lockWithin(1), "unlocking twice frees once");
    simulator.unlock();
  }

  @Test
  void lock_isNotWaitedForByWhoIsInterrupted() {
    simulator.lock();
    Thread.currentThread().interrupt();
    assertFalse(world.stepLock().lockWithin(PATIENCE_MS));
    assertTrue(Thread.interrupted());
    simulator.unlock();
  }

  /** A step that waits for its turn when the simulation is reset is not done afterwards. */
  @Test
  void reset_leavesNoStepBehind() throws InterruptedException {
    for (int i = 0; i < 50; i++) {
      simulator.startBackgroundMode();
      awaitSteps(1);
      simulator.resetSimulation();
      assertEquals(0, agent.getCounter());
    }
    steps.drainPermits();
    assertFalse(steps.tryAcquire(50, TimeUnit.MILLISECONDS));
    assertEquals(0, agent.getCounter());
  }

  @Test
  void stop_waitsForTheStepThatIsUnderWay() throws InterruptedException {
    for (int i = 0; i < 200; i++) {
      simulator.startBackgroundMode();
      awaitSteps(1);
      simulator.stopBackgroundMode();
      assertTrue(world.stepLock().lockWithin(0), "no step is under way");
      world.stepLock().unlock();
    }
  }

  private void press(int key) {
    KeyEvent event =
        new KeyEvent(application, KeyEvent.KEY_PRESSED, 0, 0, key, KeyEvent.CHAR_UNDEFINED);
    for (KeyListener listener : application.getKeyListeners()) {
      listener.keyPressed(event);
    }
  }

  @Test
  void keys_ofTheApplication_reachTheSensor_untilTheEnd() {
    press(KeyEvent.VK_LEFT);
    assertEquals(KeyEvent.VK_LEFT, keys.getLastKey());
    simulator.dispose();
    press(KeyEvent.VK_RIGHT);
    assertEquals(KeyEvent.VK_LEFT, keys.getLastKey());
  }

  @Test
  void asString_saysWhatTheInspectorShows() {
    agent.setTranslationalVelocity(0.5);
    simulator.simulateOneStep();
    String text = agent.asString();
    for (String line :
        new String[] {
          "name:      robot",
          "counter:   1",
          "lifetime:  0.050 s",
          "collision: no",
          "x:         0.025 m",
          "y:         0.250 m",
          "heading:   0.000 degrees",
          "odometer:  0.025 m",
          "translational velocity: 0.500 m/s",
          "rotational velocity: 0.000 rad/s"
        }) {
      assertTrue(text.lines().anyMatch(line::equals), line + " in\n" + text);
    }
  }
}
