package simbad.kernel.belt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;
import simbad.kernel.scene.Ball;
import simbad.kernel.scene.BodyScene;
import simbad.kernel.scene.Solid;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.TransducerPoses;

class BeltTest {
  private static final double EPSILON = 1e-9;
  private static final double HALF = Math.PI;

  private static Readings ping(BodyScene scene, BeltLayout layout, Placement belt) {
    TransducerPoses poses = new TransducerPoses(layout.size());
    Readings readings = new Readings(layout.size());
    layout.place(belt, poses);
    new RaySensor(scene, new Solid(belt), layout).ping(poses, 0, readings);
    return readings;
  }

  @Test
  void ring_secondOfFour_looksLeft() {
    BeltLayout layout = BeltLayout.ring(0.5f, 2, 4);
    TransducerPoses poses = new TransducerPoses(4);
    layout.place(Placement.at(1, 2, 3), poses);
    assertEquals(1, poses.xM(1), EPSILON);
    assertEquals(2, poses.yM(1), EPSILON);
    assertEquals(2.5, poses.zM(1), EPSILON);
    assertEquals(HALF / 2, poses.headingRad(1), EPSILON);
    assertEquals(HALF / 2, layout.angleRad(1), EPSILON);
    assertEquals(2, layout.lengthM(1), EPSILON);
  }

  @Test
  void of_pointsAndVectors_unsignedAngles() {
    double[][] positions = {{1, 0, -1}, {1, 0, 1}};
    double[][] directions = {{0, 0, -2}, {3, 0, 0}};
    BeltLayout layout = BeltLayout.of(positions, directions);
    assertEquals(HALF / 4, layout.angleRad(0), EPSILON);
    assertEquals(HALF / 4, layout.angleRad(1), EPSILON);
    assertEquals(3, layout.longestM());
    assertEquals(2, layout.lengthM(0));
  }

  @Test
  void of_badArguments_areRefused() {
    double[][] one = {{1, 0, 0}};
    double[][] zero = {{0, 0, 0}};
    assertThrows(IllegalArgumentException.class, () -> BeltLayout.of(one, new double[0][]));
    assertThrows(IllegalArgumentException.class, () -> BeltLayout.of(one, zero));
  }

  @Test
  void emptyBelt_hearsNothing() {
    BeltLayout layout = BeltLayout.ring(0.5f, 2, 0);
    assertEquals(0, ping(new BodyScene(), layout, new Placement()).size());
    assertEquals(0, layout.longestM());
  }

  @Test
  void raySensor_readsDistanceFromTheRim() {
    BodyScene scene = new BodyScene();
    scene.addFixed(new Solid(Placement.at(2, 0, 0)).add(BoxShape.ofSides(1, 1, 1)));
    Readings readings = ping(scene, BeltLayout.ring(0.25f, 2, 4), new Placement());
    assertEquals(1.25, readings.rangeM(0), EPSILON);
    assertFalse(readings.isEcho(1));
    assertFalse(readings.isEcho(2));
    assertFalse(readings.isEcho(3));
  }

  @Test
  void raySensor_inACrowd_readsTheNearest() {
    BodyScene scene = new BodyScene();
    for (int i = 0; i < 100; i++) {
      double x = 1 + 0.01 * i;
      scene.addFixed(new Solid(Placement.at(x, 0, 0)).add(BoxShape.ofSides(0.5, 1, 1)));
    }
    Readings readings = ping(scene, BeltLayout.ring(0.25f, 2, 1), new Placement());
    assertEquals(0.5, readings.rangeM(0), EPSILON);
  }

  /** In a square room of half width w, the ray at angle a from the wall's normal is w / cos a. */
  @Property(seed = "20140914")
  void raySensor_inASquareRoom_closedForm(
      @ForAll @DoubleRange(min = -4, max = 4) double turnRad,
      @ForAll @IntRange(min = 1, max = 40) int sensors) {
    BodyScene scene = new BodyScene();
    for (int wall = 0; wall < 4; wall++) {
      Placement placement = new Placement();
      placement.turnQuarters(wall);
      placement.moveTo(placement.turnedX(3, 0, 0), 0, placement.turnedZ(3, 0, 0));
      scene.addFixed(new Solid(placement).add(BoxShape.ofSides(2, 2, 8)));
    }
    Placement belt = new Placement();
    belt.turnAboutY(turnRad);
    BeltLayout layout = BeltLayout.ring(0.5f, 5, sensors);
    Readings readings = ping(scene, layout, belt);
    for (int i = 0; i < sensors; i++) {
      double heading = turnRad + layout.angleRad(i);
      double fromNormal = Math.IEEEremainder(heading, HALF / 2);
      assertEquals(2 / Math.cos(fromNormal) - 0.5, readings.rangeM(i), 1e-7);
    }
  }

  @Property(seed = "20140914")
  void enclose_holdsEveryRay(
      @ForAll @DoubleRange(min = -4, max = 4) double turnRad,
      @ForAll @IntRange(min = 1, max = 20) int sensors) {
    BeltLayout layout = BeltLayout.ring(0.5f, 2, sensors);
    Placement belt = Placement.at(1, 2, 3);
    belt.turnAboutY(turnRad);
    TransducerPoses poses = new TransducerPoses(sensors);
    layout.place(belt, poses);
    Ball ball = new Ball();
    layout.enclose(poses, ball);
    for (int i = 0; i < sensors; i++) {
      double endX = poses.xM(i) + layout.lengthM(i) * poses.directionX(i) - ball.xM();
      double endZ = poses.zM(i) + layout.lengthM(i) * poses.directionZ(i) - ball.zM();
      assertTrue(Math.hypot(endX, endZ) <= ball.radiusM());
    }
  }

  @Test
  void sectors_boundsAreIncluded() {
    BeltLayout layout = BeltLayout.ring(0.5f, 2, 8);
    Readings readings = new Readings(8);
    readings.setEcho(0, 1);
    readings.setEcho(1, 2);
    readings.setEcho(2, 4.5);
    Sectors sectors = new Sectors(layout);
    assertEquals(3, sectors.echoes(readings, 0, HALF / 2));
    assertEquals(2.5, sectors.meanRangeM(readings, 0, HALF / 2, 9), EPSILON);
    assertEquals(0, sectors.echoes(readings, HALF, 2 * HALF));
    assertEquals(9, sectors.meanRangeM(readings, HALF, 2 * HALF, 9));
  }

  @Test
  void quadrants_goRound() {
    assertEquals(0, Quadrant.FRONT_LEFT.fromRad());
    assertEquals(HALF / 2, Quadrant.FRONT_LEFT.toRad());
    assertEquals(2 * HALF, Quadrant.FRONT_RIGHT.toRad());
    assertEquals(9, Quadrant.values().length);
  }
}
