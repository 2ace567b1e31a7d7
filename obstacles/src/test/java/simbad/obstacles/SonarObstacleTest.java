package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RangeSensorBelt;
import simbad.sim.World;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.scene.Obstacle;

class SonarObstacleTest {
  private static final double TINY = 1e-12;

  private static void checkPoint(double xM, double zM, Point found) {
    assertEquals(xM, found.xM(), TINY, "x");
    assertEquals(zM, found.zM(), TINY, "z");
  }

  /**
   * FORMAT: turned by a, own (x, z) goes to (x cos a + z sin a, -x sin a + z cos a), then is moved.
   */
  @ParameterizedTest
  @CsvSource({
    // turn, own x, own z, expected offset x and z
    "0,    1, 0,  1,  0",
    // A quarter turn counter-clockwise as seen from above: +x goes to -z (up the page).
    "90,   1, 0,  0, -1",
    "90,   0, 1,  1,  0",
    "-90,  1, 0,  0,  1",
    "180,  1, 2, -1, -2",
  })
  void placement_isFormatsFrame(double turnDeg, double x, double z, double dx, double dz) {
    SonarObstacle obstacle = new AngleObstacle(new Vector3d(3, 0, -2), Math.toRadians(turnDeg));
    Point world = obstacle.worldFromObstacle().worldFromObstacle(new Point(x, z));
    checkPoint(3 + dx, -2 + dz, world);
  }

  /** Turned clockwise by 5 degrees before a fixed sensor, the bearing grows by 5. */
  @Test
  void bearing_growsWhenTurnedClockwise() {
    SonarObstacle obstacle = new AngleObstacle(new Vector3d(1, 0, 1), 0.3);
    double before = obstacle.worldFromObstacle().bearingRad(2, 2.5);
    obstacle.rotateY(-Math.toRadians(5));
    double after = obstacle.worldFromObstacle().bearingRad(2, 2.5);
    // atan2(dx, dz) - turn, with dx = 1 and dz = 1.5.
    assertEquals(Math.atan2(1, 1.5) - 0.3, before, TINY);
    assertEquals(Math.toRadians(5), after - before, TINY);
  }

  private static World world(SonarObstacle... obstacles) {
    EnvironmentDescription environment = new EnvironmentDescription();
    Stream.of(obstacles).forEach(environment::add);
    return new World(environment);
  }

  private static SonarObstacle placed(String type, double xM, double zM, double turnRad) {
    return new SonarObstacle(new Vector3d(xM, 0, zM), turnRad, Catalogue.find(type).orElseThrow());
  }

  /** As in a scene's file, but for worlds that are built in code. */
  @Test
  void overlappingObstacles_areRefusedByTheWorld() {
    SonarObstacle tee = placed("tee", 1, 0, 0.3);
    SonarObstacle plate = placed("plate", 1.01, 0, 0);
    String complaint =
        assertThrows(ObstacleOverlapException.class, () -> world(tee, plate)).getMessage();
    assertEquals(
        "obstacle plate at x 1.010, z 0.000 m overlaps obstacle tee at x 1.000, z 0.000 m",
        complaint);
  }

  /** The line that joins a pair's legs for a sensor is no body. */
  @Test
  void obstacleBetweenLegs_isNoOverlap() {
    World world = world(placed("leg-pair", 0, 0, 0), placed("square", 0, 0, 0.2));
    assertEquals(2, world.getStaticObjects().size());
    SonarObstacle inALeg = placed("round", 0.075, 0, 0);
    assertThrows(
        IllegalArgumentException.class, () -> world.addObjectToPickableSceneBranch(inALeg));
    assertEquals(2, world.getStaticObjects().size());
  }

  /** A plate of 50 mm beside a post: turned towards it they meet, along it they do not. */
  @Test
  void turn_decides() {
    assertEquals(
        2,
        world(placed("plate", 0, 0, Math.PI / 2), placed("round", 0.03, 0, 0))
            .getStaticObjects()
            .size());
    assertThrows(
        IllegalArgumentException.class,
        () -> world(placed("plate", 0, 0, 0), placed("round", 0.03, 0, 0)));
  }

  @Test
  void detachedObstacle_isInNobodysWay() {
    SonarObstacle tee = placed("tee", 0, 0, 0);
    World world = world(tee);
    world.detach(tee);
    world.addObjectToPickableSceneBranch(placed("round", 0, 0, 0));
    assertEquals(2, world.getStaticObjects().size());
  }

  @Test
  void rotate90_isAQuarterTurn() {
    SonarObstacle turned = new AngleObstacle(new Vector3d(1, 0, 2), 0);
    turned.rotate90(1);
    Point corner = turned.worldFromObstacle().worldFromObstacle(new Point(1, 0));
    checkPoint(1, 2 - 1, corner);
  }

  @Test
  void position_isCopied() {
    Vector3d position = new Vector3d(1, 0, 2);
    SonarObstacle obstacle = new RoundObstacle(position, 0);
    position.set(9, 9, 9);
    assertEquals(new Placement(1, 2, 0), obstacle.worldFromObstacle());
  }

  /** The first corner of the square is own (12.7, 12.7) mm; half a turn puts it at minus that. */
  @Test
  void asSensed_followsTheObject() {
    SonarObstacle obstacle = new SquareObstacle(new Vector3d(1, 0, 2), 0);
    Obstacle before = obstacle.asSensed();
    obstacle.translateTo(new Vector3d(0.5, 0, -1));
    obstacle.rotateY(Math.PI);
    Obstacle after = obstacle.asSensed();
    checkPoint(1.0127, 2.0127, before.worldOutline().corners().get(0));
    checkPoint(1.5 - 0.0127, 1 - 0.0127, after.worldOutline().corners().get(0));
    assertEquals("square", after.name());
    assertEquals(obstacle.type().thresholds().table().greatestM(), after.detection().greatestM());
  }

  @Test
  void shadow_isMadeOfTheTypesTable() {
    SonarObstacle obstacle = new AngleObstacle(new Vector3d(), 1);
    assertEquals(Catalogue.angleTable().table(), obstacle.shadow().table());
  }

  /**
   * A robot of 2 cm radius drives along +x at 0.2 m/s, 1 cm a step, at a post whose near face is at
   * 0.5 - 0.0127 m. It stops when its ball would touch: with its centre before 0.4673 m.
   */
  @Test
  void body_stopsAnAgent() {
    Bench bench =
        new Bench(new RangeSensorBelt(0, 0, 2.5f, 12, 0, 0), new SquareObstacle(at(0.5, 0), 0));
    bench.ping(0, 0, 0);
    bench.robot.drive(0.2);
    for (int i = 0; i < 100; i++) {
      bench.step();
    }
    Point3d place = new Point3d();
    bench.robot.getCoords(place);
    assertTrue(bench.robot.collisionDetected());
    assertEquals(0.462, place.x, 0.0101);
  }

  /** The ray straight ahead meets the square's near face at 1 - 0.0127 m. */
  @Test
  void body_isHitByAThinRay() {
    RangeSensorBelt belt = new RangeSensorBelt(0, 0, 2.5f, 12, RangeSensorBelt.TYPE_SONAR, 0);
    Bench bench = new Bench(belt, new SquareObstacle(at(1, 0), 0));
    bench.ping(0, 0, 0);
    assertTrue(belt.hasHit(0));
    assertEquals(1 - 0.0127, belt.getMeasurement(0), 1e-6);
    assertFalse(belt.hasHit(1));
    // Turned by 45 degrees, its corner is sqrt(2) * 12.7 mm ahead of its centre.
    bench = new Bench(belt, new SquareObstacle(at(1, 0), Math.PI / 4));
    bench.ping(0, 0, 0);
    assertEquals(1 - 0.0127 * Math.sqrt(2), belt.getMeasurement(0), 1e-6);
  }

  private static Vector3d at(double x, double z) {
    return new Vector3d(x, 0, z);
  }
}
