package simbad.user;

import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import simbad.gui.Simbatch;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.CherryAgent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;

/** A day of simulated time in one simulation. */
@Tag("full")
class EnduranceTest {
  /** 24 hours of 0.05 s. */
  private static final int STEPS = 1_728_000;

  private static final int CHECKS = 10;

  /** What the virtual machine may add for itself: code, profiles, loaded classes. */
  private static final long GROWTH_BYTES = 1 << 20;

  /** Circles among boxes, and has a cherry taken away and put back now and then. */
  private static final class Circler extends Agent {
    private final RangeSensorBelt sonars;
    private final CherryAgent cherry;
    private long echoes;

    Circler(CherryAgent cherry) {
      super(new Vector3d(), "circler");
      this.cherry = cherry;
      sonars = RobotFactory.addSonarBeltSensor(this, 12);
      sonars.setUpdateOnEachFrame(true);
      RobotFactory.addBumperBeltSensor(this);
      RobotFactory.addLamp(this).setBlink(true);
    }

    @Override
    protected void performBehavior() {
      setTranslationalVelocity(0.5);
      setRotationalVelocity(0.8);
      echoes += sonars.oneHasHit() ? 1 : 0;
      if (getCounter() % 100 == 0) {
        cherry.detach();
      } else if (getCounter() % 100 == 50) {
        cherry.attach();
      }
    }
  }

  @Test
  void steps_ofADay_leaveNothingOnTheHeap() {
    EnvironmentDescription environment = new EnvironmentDescription();
    CherryAgent cherry = new CherryAgent(new Vector3d(0.5, 0, -1), "cherry", 0.1f);
    Circler circler = new Circler(cherry);
    environment.add(circler);
    environment.add(cherry);
    for (int i = 0; i < 100; i++) {
      double angle = i * 2.4;
      double radius = 1.5 + 0.1 * i;
      environment.add(
          new Box(
              new Vector3d(radius * Math.cos(angle), 0, radius * Math.sin(angle)),
              new Vector3f(0.4f, 1, 0.4f),
              environment));
    }
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    run(simulation, STEPS / CHECKS);
    long first = usedBytes();
    for (int check = 1; check < CHECKS; check++) {
      run(simulation, STEPS / CHECKS);
      long grown = usedBytes() - first;
      assertTrue(grown < GROWTH_BYTES, grown + " bytes more in part " + check);
    }
    assertTrue(circler.getCounter() == STEPS && circler.echoes > STEPS / 10, "" + circler.echoes);
  }

  private static void run(Simbatch simulation, int steps) {
    for (int i = 0; i < steps; i++) {
      simulation.step();
    }
  }

  private static long usedBytes() {
    System.gc();
    System.gc();
    return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
  }
}
