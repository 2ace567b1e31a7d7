package simbad.user;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import javax.vecmath.Point3d;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.gui.Simbatch;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.SimpleAgent;

/**
 * The programs of {@code src/test/oldprograms} compile against the public names, as they are
 * written and without this project's rules, and do what they were written for.
 */
class OldProgramsTest {
  private static ClassLoader loader;

  @BeforeAll
  static void compile(@TempDir Path classes) throws IOException {
    loader = OldPrograms.compile(classes);
  }

  private static EnvironmentDescription run(String program, int steps)
      throws ReflectiveOperationException {
    Object made = loader.loadClass("oldprograms." + program).getDeclaredConstructor().newInstance();
    EnvironmentDescription environment = (EnvironmentDescription) made;
    Simbatch simulation = new Simbatch(environment, false);
    simulation.reset();
    for (int i = 0; i < steps; i++) {
      simulation.step();
    }
    simulation.dispose();
    return environment;
  }

  private static Agent agent(Object environment, String field) throws ReflectiveOperationException {
    return (Agent) environment.getClass().getField(field).get(environment);
  }

  private static double number(Object object, String field) throws ReflectiveOperationException {
    return ((Number) object.getClass().getField(field).get(object)).doubleValue();
  }

  private static Point3d coords(SimpleAgent agent) {
    Point3d coords = new Point3d();
    agent.getCoords(coords);
    return coords;
  }

  private static void checkInside(double half, double way, Agent agent) {
    Point3d at = coords(agent);
    assertTrue(Math.abs(at.x) < half && Math.abs(at.z) < half, "at " + at);
    assertTrue(agent.getOdometer() > way, "odometer " + agent.getOdometer());
  }

  @Test
  void wallAvoider_staysBetweenItsWalls() throws ReflectiveOperationException {
    checkInside(4, 2, agent(run("WallAvoider", 800), "robot"));
  }

  @Test
  void quadrantAvoider_getsOn() throws ReflectiveOperationException {
    Agent walker = agent(run("QuadrantAvoider", 400), "walker");
    assertTrue(walker.getOdometer() > 2, "odometer " + walker.getOdometer());
  }

  @Test
  void boundaryFollower_keepsItsDistance() throws ReflectiveOperationException {
    Agent follower = agent(run("BoundaryFollower", 1000), "robot");
    assertEquals(0.8, number(follower, "nearest"), 0.2);
    checkInside(2.5, 8, follower);
  }

  @Test
  void lineFollower_staysOnTheLine() throws ReflectiveOperationException {
    Agent follower = agent(run("LineFollower", 300), "follower");
    assertTrue(number(follower, "seen") > 300);
    assertEquals(0, coords(follower).z, 0.08);
    assertTrue(coords(follower).x > 3);
  }

  @Test
  void cherryPicker_picksAll() throws ReflectiveOperationException {
    assertEquals(5, number(agent(run("CherryPicker", 300), "picker"), "picked"));
  }

  @Test
  void khepera_staysInItsBox() throws ReflectiveOperationException {
    checkInside(0.2, 0.2, agent(run("KheperaMaze", 600), "robot"));
  }

  @Test
  void blinkers_meetAndStop() throws ReflectiveOperationException {
    Object environment = run("Blinkers", 200);
    Agent[] blinkers = (Agent[]) environment.getClass().getField("blinkers").get(environment);
    assertEquals(2, number(blinkers[0], "devices"));
    assertTrue(blinkers[0].collisionDetected() && blinkers[1].anOtherAgentIsVeryNear());
    assertEquals(0.6, coords(blinkers[0]).distance(coords(blinkers[1])), 0.051);
  }

  @Test
  void potentialField_leadsToTheGoal() throws ReflectiveOperationException {
    Agent seeker = agent(run("PotentialField", 800), "seeker");
    assertTrue(coords(seeker).distance(new Point3d(4, 0.25, 0)) < 0.35, "at " + coords(seeker));
  }

  @Test
  void lightSeeker_findsTheLamp() throws ReflectiveOperationException {
    assertTrue(number(agent(run("LightSeeker", 900), "seeker"), "nearest") < 1);
  }

  @Test
  void luxClimber_stopsAtTheLamp() throws ReflectiveOperationException {
    Agent climber = agent(run("LuxClimber", 800), "climber");
    assertTrue(coords(climber).distance(new Point3d(3, 0.25, 2)) < 0.5, "at " + coords(climber));
  }

  @Test
  void ballWatcher_seesTheCherryAndGetsIt() throws ReflectiveOperationException {
    Agent watcher = agent(run("BallWatcher", 500), "watcher");
    assertTrue(number(watcher, "found") > 50);
    assertEquals(0.8, number(watcher, "brightness"), 1e-6);
    assertTrue(coords(watcher).distance(new Point3d(3, 0.25, -2)) < 0.5, "at " + coords(watcher));
  }

  @Test
  void mapMaze_holdsTheTurtle() throws ReflectiveOperationException {
    checkInside(2.5, 1, agent(run("MapMaze", 400), "turtle"));
  }

  @Test
  void ownParts_areUsed() throws ReflectiveOperationException {
    Agent cart = agent(run("OwnParts", 200), "cart");
    // 5 s at 0.5 m/s to the left; going back to the start stops the kinematic model, each step
    // anew.
    assertEquals(2.5, cart.getOdometer(), 0.03);
    assertEquals(0, coords(cart).z, 1e-9);
    assertTrue(number(cart, "resets") >= 1);
  }
}
