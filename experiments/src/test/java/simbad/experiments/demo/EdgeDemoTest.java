package simbad.experiments.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.vecmath.Point3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.demo.DemoManager;
import simbad.experiments.run.FollowerRobot;
import simbad.gui.Simbatch;
import simbad.obstacles.Catalogue;
import simbad.obstacles.SonarObstacle;
import simbad.sim.World;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.Overlap;

class EdgeDemoTest {
  /** The robot is a few centimetres wide: seen with the whole floor it is a dot. */
  @ParameterizedTest
  @ValueSource(strings = {"SquareDemo", "RoundDemo", "AngleDemo"})
  void window_beginsNearTheRobot(String name) {
    assertEquals(World.VIEW_INWARDS, DemoManager.find(name).orElseThrow().worldViewPoint);
  }

  /** Once the edge is found, the robot stays within a few of its steps, and gets on round it. */
  @ParameterizedTest
  @ValueSource(strings = {"SquareDemo", "RoundDemo", "AngleDemo"})
  void robot_followsTheEdge(String name) {
    EdgeDemo demo = (EdgeDemo) DemoManager.find(name).orElseThrow();
    Outline edge = Outline.of(demo.type.thresholds().table().points());
    Simbatch simulation = new Simbatch(demo, false);
    simulation.reset();
    Point3d at = new Point3d();
    double woundRad = 0;
    double bearingRad = 0;
    int steps = 0;
    for (; Math.abs(woundRad) < Angles.TURN_RAD; steps++) {
      simulation.step();
      demo.robot.getCoords(at);
      double nowRad = Math.atan2(at.x, at.z);
      woundRad += steps == 0 ? 0 : Angles.signed(nowRad - bearingRad);
      bearingRad = nowRad;
      if (steps > 400) {
        assertTrue(edge.distanceM(at.x, at.z) < 0.1, "step " + steps + " at " + at);
      }
      assertTrue(steps < 20_000, "not round by " + woundRad);
    }
    // It weaves across the edge, 30 degrees to each side, and walks triangles in narrow places.
    assertTrue(demo.robot.getOdometer() < 2 * edge.perimeterM(), "" + demo.robot.getOdometer());
  }

  /** Each on its own angle; a robot that turns late and slowly comes as near the edge. */
  @Test
  void realRobots_followTheEdge_eachInItsOwnWay() {
    RealRobotsDemo demo = (RealRobotsDemo) DemoManager.find("RealRobotsDemo").orElseThrow();
    Simbatch simulation = new Simbatch(demo, false);
    simulation.reset();
    for (int i = 0; i < 40_000; i++) {
      simulation.step();
    }
    assertEquals(
        List.of("as told", "create-1", "create-2", "create-3"),
        demo.robots.stream().map(FollowerRobot::getName).toList());
    Set<Double> driven = new HashSet<>();
    for (int i = 0; i < demo.robots.size(); i++) {
      SonarObstacle angle = demo.angles.get(i);
      Outline edge = Outline.of(angle.type().thresholds().table().points());
      Point3d at = new Point3d();
      demo.robots.get(i).getCoords(at);
      Placement place = angle.worldFromObstacle();
      double off = edge.distanceM(at.x - place.xM(), at.z - place.zM());
      assertTrue(off < 0.05, demo.robots.get(i).getName() + ": " + off);
      driven.add(demo.robots.get(i).getOdometer());
    }
    assertEquals(4, driven.size(), "no two move alike");
  }

  /** Nine types far enough apart that no two lie over each other, each turned another way. */
  @Test
  void obstacles_standApartAndTurned() {
    World world = new World(DemoManager.find("ObstaclesDemo").orElseThrow());
    List<SonarObstacle> obstacles =
        world.getStaticObjects().stream()
            .filter(SonarObstacle.class::isInstance)
            .map(SonarObstacle.class::cast)
            .toList();
    assertEquals(Catalogue.shipped().size(), obstacles.size());
    for (SonarObstacle one : obstacles) {
      for (SonarObstacle other : obstacles) {
        assertTrue(
            one == other
                || !Overlap.of(one.asSensed().worldOutline(), other.asSensed().worldOutline()));
      }
    }
    assertEquals(
        obstacles.size(),
        obstacles.stream().map(o -> o.worldFromObstacle().turnRad()).distinct().count());
  }
}
