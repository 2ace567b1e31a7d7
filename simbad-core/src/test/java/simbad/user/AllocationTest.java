package simbad.user;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import simbad.gui.Simbatch;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RobotFactory;

/** A step allocates nothing once everything has been used. */
class AllocationTest {
  private static final int STEPS = 2000;
  private static final int ROUNDS = 60;

  /** Far less than one object per step; classes that load meanwhile need a little. */
  private static final double BYTES_PER_STEP = 4;

  /** Circles in place. */
  private static class Circler extends Agent {
    Circler(double x, double z) {
      super(new Vector3d(x, 0, z), "circler");
      RobotFactory.addSonarBeltSensor(this, 12).setUpdateOnEachFrame(true);
      RobotFactory.addBumperBeltSensor(this);
    }

    @Override
    protected void performBehavior() {
      setTranslationalVelocity(0.5);
      setRotationalVelocity(0.8);
    }
  }

  /** Circles in place and films. */
  private static final class Filmer extends Circler {
    Filmer(double x, double z) {
      super(x, z);
      RobotFactory.addCameraSensor(this);
      RobotFactory.addLightSensorLeft(this).setUpdateOnEachFrame(true);
    }
  }

  private static Simbatch crowd() {
    EnvironmentDescription environment = new EnvironmentDescription();
    for (double x = 0; x < 12; x += 2.5) {
      for (double z = 0; z < 12; z += 2.5) {
        environment.add(new Box(new Vector3d(x, 0, z), new Vector3f(0.6f, 1, 0.6f), environment));
        environment.add(new Circler(x + 1.25, z + 1.25));
      }
    }
    environment.add(new Filmer(-1.25, -1.25));
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    return simulation;
  }

  private static void run(Simbatch simulation) {
    for (int i = 0; i < STEPS; i++) {
      simulation.step();
    }
  }

  /**
   * On a busy machine the compiler takes its time: the test waits for it in rounds, not by the
   * clock.
   */
  @Test
  void steps_afterWarmUp_allocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    Simbatch simulation = crowd();
    double bytesPerStep = Double.POSITIVE_INFINITY;
    for (int round = 0; round < ROUNDS && bytesPerStep >= BYTES_PER_STEP; round++) {
      long before = threads.getCurrentThreadAllocatedBytes();
      run(simulation);
      bytesPerStep = (threads.getCurrentThreadAllocatedBytes() - before) / (double) STEPS;
    }
    assertTrue(bytesPerStep < BYTES_PER_STEP, bytesPerStep + " bytes per step");
  }
}
