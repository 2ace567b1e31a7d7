package simbad.parity;

import java.util.ArrayList;
import java.util.List;
import javax.media.j3d.Transform3D;
import javax.vecmath.Matrix3d;
import javax.vecmath.Point3d;
import simbad.sim.Agent;
import simbad.sim.LampActuator;
import simbad.sim.LineSensor;
import simbad.sim.RangeSensorBelt;
import simbad.sim.SimpleAgent;

/** Writes the state of an agent as a row of a recorded trace: names of columns and values. */
final class TraceRecorder {
  /** One cell of a row: a number or a word, which is the name of an agent or a dash. */
  record Cell(String column, double number, String word) {
    static Cell of(String column, double number) {
      return new Cell(column, number, "");
    }

    static Cell of(String column, boolean flag) {
      return of(column, flag ? 1 : 0);
    }
  }

  private final Scenario scenario;
  private final List<Cell> cells = new ArrayList<>();

  TraceRecorder(Scenario scenario) {
    this.scenario = scenario;
  }

  List<Cell> row(int step, SimpleAgent agent) {
    cells.clear();
    add("step", step);
    if (scenario.extras.contains(Scenario.Extra.LINES)) {
      addLineRow((Agent) agent);
      return List.copyOf(cells);
    }
    cells.add(new Cell("agent", 0, agent.getName()));
    addPose(agent);
    double[] commands = scenario.commands(agent);
    add("cmdT", commands[0]);
    add("cmdR", commands[1]);
    cells.add(Cell.of("collision", agent.collisionDetected()));
    cells.add(Cell.of("interaction", agent.interactionDetected()));
    SimpleAgent near = agent.getVeryNearAgent();
    cells.add(new Cell("veryNear", 0, near == null ? "-" : near.getName()));
    if (agent instanceof Agent robot) {
      add("odometer", robot.getOdometer());
    } else {
      cells.add(new Cell("odometer", 0, "-"));
    }
    add("lifetime", agent.getLifeTime());
    add("counter", agent.getCounter());
    scenario.extras.forEach(extra -> addExtra(extra, agent));
    return List.copyOf(cells);
  }

  /** The format of the derivative of 2011. */
  private void addLineRow(Agent agent) {
    addPose(agent);
    double[] commands = scenario.commands(agent);
    add("cmdT", commands[0]);
    add("cmdR", commands[1]);
    cells.add(Cell.of("collision", agent.collisionDetected()));
    LineSensor lines = (LineSensor) agent.getSensorDevice(0);
    for (int i = 0; i < lines.getNumSensors(); i++) {
      cells.add(Cell.of("hit" + i, lines.hasHit(i)));
      add("range" + i, lines.getMeasurement(i));
    }
  }

  private void add(String column, double value) {
    cells.add(Cell.of(column, value));
  }

  private void addPose(SimpleAgent agent) {
    Point3d p = new Point3d();
    agent.getCoords(p);
    add("x", p.x);
    add("y", p.y);
    add("z", p.z);
    Transform3D rotation = new Transform3D();
    agent.getRotationTransform(rotation);
    Matrix3d m = new Matrix3d();
    rotation.get(m);
    add("heading", Math.atan2(m.m02, m.m00));
  }

  private void addExtra(Scenario.Extra extra, SimpleAgent agent) {
    switch (extra) {
      case BELT -> addBelt(agent, 0);
      case BELT_2 -> addBelt(agent, 1);
      case QUADRANTS -> addQuadrants(Scenario.belt(agent, 0));
      case LINES -> throw new IllegalStateException("lines have rows of their own");
      case LAMP -> addLamp((LampActuator) agent.getActuatorDevice(0));
    }
  }

  /** Agents without sensors have no columns of their own. */
  private void addBelt(SimpleAgent agent, int number) {
    if (agent.getSensorList().isEmpty()) {
      return;
    }
    RangeSensorBelt belt = Scenario.belt(agent, number);
    cells.add(Cell.of("any", belt.oneHasHit()));
    for (int i = 0; i < belt.getNumSensors(); i++) {
      cells.add(Cell.of("hit" + i, belt.hasHit(i)));
      add("range" + i, belt.getMeasurement(i));
    }
  }

  private void addQuadrants(RangeSensorBelt b) {
    add("quad front", b.getFrontQuadrantMeasurement());
    add("quad frontLeft", b.getFrontLeftQuadrantMeasurement());
    add("quad frontRight", b.getFrontRightQuadrantMeasurement());
    add("quad left", b.getLeftQuadrantMeasurement());
    add("quad right", b.getRightQuadrantMeasurement());
    add("quad back", b.getBackQuadrantMeasurement());
    add("quad backLeft", b.getBackLeftQuadrantMeasurement());
    add("quad backRight", b.getBackRightQuadrantMeasurement());
    add("hits front", b.getFrontQuadrantHits());
    add("hits frontLeft", b.getFrontLeftQuadrantHits());
    add("hits frontRight", b.getFrontRightQuadrantHits());
    add("hits left", b.getLeftQuadrantHits());
    add("hits right", b.getRightQuadrantHits());
    add("hits back", b.getBackQuadrantHits());
    add("hits backLeft", b.getBackLeftQuadrantHits());
    add("hits backRight", b.getBackRightQuadrantHits());
  }

  private void addLamp(LampActuator lamp) {
    cells.add(Cell.of("on", lamp.getOn()));
    cells.add(Cell.of("blink", lamp.getBlink()));
  }
}
