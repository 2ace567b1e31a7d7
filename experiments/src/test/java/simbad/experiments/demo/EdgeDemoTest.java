package simbad.experiments.demo;

import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.vecmath.Point3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.demo.DemoManager;
import simbad.gui.Simbatch;
import simbad.sonar.frame.Angles;
import simbad.sonar.shape.Outline;

class EdgeDemoTest {
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
}
