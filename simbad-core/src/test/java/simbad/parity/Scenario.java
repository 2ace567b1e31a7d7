package simbad.parity;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sim.SimpleAgent;

/** A recorded scenario: an environment, whose agents appear in the trace in this order. */
class Scenario extends EnvironmentDescription {
  /** What is recorded beside the state of an agent. */
  enum Extra {
    BELT,
    BELT_2,
    QUADRANTS,
    LAMP,
    LINES
  }

  /** A robot that remembers what it was told last, as the recording driver did. */
  abstract static class Driver extends Agent {
    double commandT;
    double commandR;
    int n;

    Driver(Vector3d position, String name) {
      super(position, name);
    }

    @Override
    protected void performBehavior() {
      drive(n);
      n++;
    }

    abstract void drive(int n);

    void vel(double t, double r) {
      commandT = t;
      commandR = r;
      setTranslationalVelocity(t);
      setRotationalVelocity(r);
    }
  }

  final List<SimpleAgent> agents = new ArrayList<>();
  final List<Extra> extras = new ArrayList<>();

  <T extends SimpleAgent> T addAgent(T agent) {
    add(agent);
    agents.add(agent);
    return agent;
  }

  void box(double x, double y, double z, float sx, float sy, float sz) {
    add(new Box(new Vector3d(x, y, z), new Vector3f(sx, sy, sz), this));
  }

  /** Adds a belt of bumpers and one of sonars, the sonars last or first, of every step. */
  void addBoth(Driver robot, int first, int second, boolean bumpersFirst) {
    RangeSensorBelt one =
        bumpersFirst
            ? RobotFactory.addBumperBeltSensor(robot, first)
            : RobotFactory.addSonarBeltSensor(robot, first);
    RangeSensorBelt other =
        bumpersFirst
            ? RobotFactory.addSonarBeltSensor(robot, second)
            : RobotFactory.addBumperBeltSensor(robot, second);
    one.setUpdateOnEachFrame(true);
    other.setUpdateOnEachFrame(true);
    extras.add(Extra.BELT);
    extras.add(Extra.BELT_2);
  }

  /** Returns what the controller of an agent commanded last. */
  double[] commands(SimpleAgent agent) {
    return agent instanceof Driver driver
        ? new double[] {driver.commandT, driver.commandR}
        : new double[] {0, 0};
  }

  static RangeSensorBelt belt(SimpleAgent agent, int number) {
    return (RangeSensorBelt) agent.getSensorDevice(number);
  }
}
