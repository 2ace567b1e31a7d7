package simbad.demo;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import javax.vecmath.Point3d;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.SimpleAgent;
import simbad.sim.Simulator;
import simbad.sim.World;

/** Runs an environment without a window and remembers where everybody was. */
final class Watch {
  static final int STEPS = 2000;

  private final Simulator simulator;
  private final Map<SimpleAgent, List<Point3d>> ways = new HashMap<>();
  private final Map<SimpleAgent, Integer> collisions = new HashMap<>();

  private Watch(EnvironmentDescription environment) {
    simulator = new Simulator(null, new World(environment), environment);
    simulator.resetSimulation();
    simulator.initBehaviors();
  }

  static Watch of(EnvironmentDescription environment) {
    return of(environment, () -> {});
  }

  /** Calls {@code afterStep} after each step. */
  static Watch of(EnvironmentDescription environment, Runnable afterStep) {
    Watch watch = new Watch(environment);
    for (int i = 0; i < STEPS; i++) {
      watch.simulator.simulateOneStep();
      watch.simulator.getAgentList().forEach(watch::note);
      afterStep.run();
    }
    watch.simulator.dispose();
    return watch;
  }

  private void note(SimpleAgent agent) {
    ways.computeIfAbsent(agent, key -> new ArrayList<>()).add(at(agent));
    collisions.merge(agent, agent.collisionDetected() ? 1 : 0, Integer::sum);
  }

  static Point3d at(SimpleAgent agent) {
    Point3d at = new Point3d();
    agent.getCoords(at);
    return at;
  }

  List<SimpleAgent> agents() {
    return simulator.getAgentList();
  }

  List<Point3d> way(SimpleAgent agent) {
    return ways.getOrDefault(agent, List.of());
  }

  int collisions(SimpleAgent agent) {
    return collisions.getOrDefault(agent, 0);
  }

  double displacement(SimpleAgent agent) {
    List<Point3d> way = way(agent);
    return way.get(0).distance(way.get(way.size() - 1));
  }

  /** The robot gets about: over the run, and in every 15 s of it; and stays in a square. */
  void checkGetsAbout(Agent robot, double leastWayM, double halfM) {
    assertTrue(robot.getOdometer() > leastWayM, robot.getName() + ": " + robot.getOdometer());
    List<Point3d> way = way(robot);
    for (int from = 0; from + 300 <= way.size(); from += 10) {
      Point3d start = way.get(from);
      double reach =
          way.subList(from, from + 300).stream().mapToDouble(start::distance).max().orElse(0);
      assertTrue(reach > leastWayM / 100, robot.getName() + " stays at " + start);
    }
    assertTrue(
        way.stream().allMatch(p -> Math.abs(p.x) < halfM && Math.abs(p.z) < halfM),
        robot.getName() + " got out");
  }
}
