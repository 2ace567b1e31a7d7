package simbad.cli;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import javax.vecmath.Point3d;
import simbad.demo.Demo;
import simbad.sim.Agent;
import simbad.sim.SimpleAgent;
import simbad.sim.Simulator;
import simbad.sim.World;

/** A demo that runs without a window, and what there is to say of it. */
final class HeadlessDemo {
  private static final class Events {
    private int blocked;
    private int impacts;
  }

  private final Demo demo;
  private final Simulator simulator;
  private final Map<SimpleAgent, Events> events = new LinkedHashMap<>();
  private int steps;

  HeadlessDemo(Demo demo) {
    this.demo = demo;
    simulator = new Simulator(null, new World(demo), demo);
    simulator.resetSimulation();
    simulator.initBehaviors();
    simulator.getAgentList().forEach(agent -> events.put(agent, new Events()));
  }

  void step() {
    simulator.simulateOneStep();
    steps++;
    events.forEach(HeadlessDemo::note);
  }

  private static void note(SimpleAgent agent, Events noted) {
    noted.blocked += agent.collisionDetected() ? 1 : 0;
    noted.impacts += agent.interactionDetected() ? 1 : 0;
  }

  void print(PrintWriter out, double takenS) {
    double simulatedS = steps / 20.0;
    out.printf(
        Locale.ROOT,
        "%s: %d steps (%.1f s simulated), %.0f steps/s%n",
        demo.getClass().getSimpleName(),
        steps,
        simulatedS,
        steps / takenS);
    events.forEach((agent, noted) -> out.println("  " + line(agent, noted)));
  }

  private static String line(SimpleAgent agent, Events noted) {
    if (!agent.getSolid().isPresent()) {
      return agent.getName() + ": taken out of the world";
    }
    Point3d at = new Point3d();
    agent.getCoords(at);
    StringBuilder line =
        new StringBuilder(
            String.format(
                Locale.ROOT,
                "%s: at x %.2f, z %.2f m, heading %.0f degrees",
                agent.getName(),
                at.x,
                at.z,
                Math.toDegrees(agent.getHeadingRad())));
    if (agent instanceof Agent robot) {
      line.append(String.format(Locale.ROOT, ", drove %.2f m", robot.getOdometer()));
    }
    line.append(noted.blocked > 0 ? ", blocked in " + noted.blocked + " steps" : "");
    line.append(noted.impacts > 0 ? ", bumped in " + noted.impacts + " steps" : "");
    return line.toString();
  }
}
