package simbad.sonar.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;

import net.jqwik.api.ForAll;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Seeded;

class PlacementTest {
  private static final double EXACT = 1e-12;

  /** Turn, own point, its place in the world: a turn is counter-clockwise, that is +x to -z. */
  @ParameterizedTest
  @CsvSource({
    "0, 1, 2, 1, 2",
    "90, 1, 0, 0, -1",
    "90, 0, 1, 1, 0",
    "180, 1, 2, -1, -2",
    "-90, 1, 0, 0, 1",
    "45, 1, 0, 0.7071067811865, -0.7071067811865",
    "30, 0, 1, 0.5, 0.8660254037844"
  })
  void worldFromObstacle_turnsCounterClockwise(
      double turnDeg, double ownX, double ownZ, double worldX, double worldZ) {
    Placement placement = new Placement(10, -20, Math.toRadians(turnDeg));
    checkPoint(10 + worldX, -20 + worldZ, placement.worldFromObstacle(new Point(ownX, ownZ)));
  }

  private static void checkPoint(double x, double z, Point point) {
    assertEquals(x, point.xM(), EXACT);
    assertEquals(z, point.zM(), EXACT);
  }

  /** Where the sensor stands from the obstacle, the obstacle's turn, the bearing. */
  @ParameterizedTest
  @CsvSource({
    "0, 1, 0, 0", "1, 0, 0, 90", "0, -1, 0, 180", "-1, 0, 0, 270", "1, 1, 0, 45",
    "0, 1, -5, 5", "0, 1, 5, 355", "1, 0, 90, 0", "-1, 0, -90, 0", "3, 4, 0, 36.869897645844",
    "0, 1, 720, 0", "0, 0, 0, 0", "0, 0, 5, 355"
  })
  void bearing_inClosedForm(double dx, double dz, double turnDeg, double bearingDeg) {
    Placement placement = new Placement(-3, 7, Math.toRadians(turnDeg));
    double bearing = placement.bearingRad(-3 + dx, 7 + dz);
    assertEquals(bearingDeg, Math.toDegrees(bearing), 1e-9);
  }

  @Seeded
  void bearing_growsBy5_whenTheObstacleIsTurnedClockwiseBy5(
      @ForAll @DoubleRange(min = -4, max = 4) double dx,
      @ForAll @DoubleRange(min = 0.1, max = 4) double dz,
      @ForAll @DoubleRange(min = -180, max = 180) double turnDeg) {
    Placement before = new Placement(1, 2, Math.toRadians(turnDeg));
    Placement after = new Placement(1, 2, Math.toRadians(turnDeg - 5));
    double growth = after.bearingRad(1 + dx, 2 + dz) - before.bearingRad(1 + dx, 2 + dz);
    assertEquals(5, Math.toDegrees(Angles.positive(growth)), 1e-9);
  }

  @Seeded
  void points_goThereAndBack(
      @ForAll @DoubleRange(min = -10, max = 10) double x,
      @ForAll @DoubleRange(min = -10, max = 10) double z,
      @ForAll @DoubleRange(min = -1000, max = 1000) double turnDeg) {
    Placement placement = new Placement(z / 3, -x / 2, Math.toRadians(turnDeg));
    Point point = new Point(x, z);
    checkPoint(x, z, placement.obstacleFromWorld(placement.worldFromObstacle(point)));
    checkPoint(x, z, placement.worldFromObstacle(placement.obstacleFromWorld(point)));
  }

  /** The bearing is the direction of the place in the own frame: 0 along +z, 90 along +x. */
  @Seeded
  void bearingAndDistance_areThoseOfTheOwnFrame(
      @ForAll @DoubleRange(min = -10, max = 10) double x,
      @ForAll @DoubleRange(min = 0.01, max = 10) double z,
      @ForAll @DoubleRange(min = -360, max = 360) double turnDeg) {
    Placement placement = new Placement(0.5, -0.25, Math.toRadians(turnDeg));
    Point own = placement.obstacleFromWorld(new Point(x, z));
    double off = Math.atan2(own.xM(), own.zM()) - placement.bearingRad(x, z);
    assertEquals(0, Angles.signed(off), 1e-9);
    assertEquals(Math.hypot(own.xM(), own.zM()), placement.centreDistanceM(x, z), EXACT);
  }

  @Test
  void identity_leavesPointsWhereTheyAre() {
    assertEquals(new Point(3, -4), Placement.IDENTITY.worldFromObstacle(new Point(3, -4)));
  }
}
