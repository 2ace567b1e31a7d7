package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.Locale;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

class SimulatorTest {
  private final CountDownLatch steps = new CountDownLatch(3);
  private final EnvironmentDescription environment = new EnvironmentDescription();
  private final Agent agent =
      new Agent(new Vector3d(), "robot") {
        @Override
        protected void performBehavior() {
          steps.countDown();
        }
      };

  private Simulator simulator() {
    environment.add(agent);
    return new Simulator(null, new World(environment), environment);
  }

  private void checkSteps() throws InterruptedException {
    assertTrue(steps.await(30, TimeUnit.SECONDS));
  }

  @Test
  void start_stepsByItself() throws InterruptedException {
    Simulator simulator = simulator();
    simulator.setVirtualTimeFactor(20);
    simulator.restartSimulation();
    checkSteps();
    simulator.stopSimulation();
    simulator.dispose();
  }

  @Test
  void backgroundMode_stepsByItself() throws InterruptedException {
    Simulator simulator = simulator();
    simulator.startBackgroundMode();
    checkSteps();
    simulator.stopBackgroundMode();
  }

  @Test
  void lock_holdsSteps() throws InterruptedException {
    Simulator simulator = simulator();
    simulator.lock();
    simulator.startBackgroundMode();
    Thread.sleep(20);
    assertEquals(3, steps.getCount());
    simulator.unlock();
    checkSteps();
    simulator.stopBackgroundMode();
  }

  @Test
  void performSimulationStep_doesOne() {
    Simulator simulator = simulator();
    simulator.performSimulationStep();
    assertEquals(1, agent.getCounter());
    assertEquals(agent, simulator.getAgentList().get(0));
  }

  @Test
  void reset_zeroesCounters() {
    Simulator simulator = simulator();
    agent.setTranslationalVelocity(1);
    simulator.simulateOneStep();
    assertEquals(0.05, agent.getOdometer(), 1e-9);
    simulator.resetSimulation();
    assertEquals(0, agent.getOdometer());
    assertEquals(0, agent.getCounter());
    assertEquals(0, agent.getTranslationalVelocity());
  }

  @Test
  void framesPerSecond_setTheStep() {
    Simulator simulator = simulator();
    simulator.setFramesPerSecond(10);
    simulator.simulateOneStep();
    assertEquals(0.1, agent.getLifeTime(), 1e-12);
    assertEquals(10, agent.getFramesPerSecond());
    assertThrows(IllegalArgumentException.class, () -> simulator.setFramesPerSecond(0));
    assertThrows(IllegalArgumentException.class, () -> simulator.setVirtualTimeFactor(0));
  }

  @Test
  void settings_areKept() {
    Simulator simulator = simulator();
    assertEquals(1, simulator.getVirtualTimeFactor());
    assertFalse(simulator.getUsePhysics());
    simulator.setUsePhysics(true);
    assertTrue(simulator.getUsePhysics());
    simulator.setApplicationComponent(null);
    assertEquals(null, simulator.applicationComponent());
  }

  @Test
  void blockWorldColours_areDimmed() {
    Arch arch = new Arch(new Vector3d(), environment);
    arch.setColor(new Color3f(1, 0.5f, 0));
    assertEquals(new Color3f(0.8f, 0.5f, 0), arch.color());
    assertEquals(new Color3f(0.8f, 0.5f, 0), arch.children().get(0).color());
  }

  @Test
  void blinkingLamp_changesAtEachUpdate() {
    LampActuator lamp = RobotFactory.addLamp(agent);
    lamp.setOn(true);
    assertTrue(lamp.isLit());
    lamp.setBlink(true);
    lamp.update();
    assertFalse(lamp.isLit());
    lamp.update();
    assertTrue(lamp.isLit());
  }

  @Test
  void plan_atItsEnd_stopsOnce() {
    Plan plan = new Plan(agent);
    plan.forward(0.1, 0.1);
    plan.doStep();
    assertEquals(0, agent.getTranslationalVelocity());
    plan.reset();
    plan.doStep();
    plan.doStep();
    assertEquals(1, agent.getTranslationalVelocity());
    plan.doStep();
    assertEquals(0, agent.getTranslationalVelocity());
    agent.setTranslationalVelocity(0.3);
    plan.doStep();
    assertEquals(0.3, agent.getTranslationalVelocity());
  }

  @Test
  void frameMeter_measuresSteps() {
    FrameMeter meter = new FrameMeter();
    meter.setUpdateRate(2);
    assertEquals(0, meter.fps);
    assertEquals(2, meter.getUpdateRate());
    meter.measurePoint(3);
    assertTrue(meter.fps > 0 && meter.fpsSinceStart > 0);
    meter.reset();
    assertEquals(0, meter.fps);
    assertThrows(IllegalArgumentException.class, () -> meter.setUpdateRate(0));
    agent.setFrameMeterRate(5);
  }

  @Test
  void kinematicModels_describeThemselves() {
    DecimalFormat format = new DecimalFormat("0.0", DecimalFormatSymbols.getInstance(Locale.ROOT));
    agent.setTranslationalVelocity(0.5);
    assertTrue(agent.getKinematicModel().toString(format).contains("0.5"));
    DifferentialKinematic wheels = RobotFactory.setDifferentialDriveKinematicModel(agent);
    wheels.setWheelsVelocity(0.2, 0.3);
    assertTrue(agent.getKinematicModel().toString(format).contains("0.3"));
  }
}
