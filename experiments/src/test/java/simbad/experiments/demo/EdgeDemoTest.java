package simbad.experiments.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javax.vecmath.Point3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.demo.DemoManager;
import simbad.gui.Simbatch;
import simbad.obstacles.Catalogue;
import simbad.obstacles.SonarObstacle;
import simbad.sim.World;
import simbad.sonar.frame.Angles;
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
