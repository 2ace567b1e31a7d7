package simbad.blindworld.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** How a square of 0.2 m lies before a transducer, from a drawing. */
class BodyTest {

  private static final double HALF_M = 0.1;

  /** Samples are 2 mm apart and a tenth of that round the nearest one. */
  private static final double SAMPLING_M = 1e-4;

  private static final Pose ORIGIN = new Pose(0, 0, 0);
  private static final Shadow SHADOW = Shadow.uniform(2);
  private static final List<Point> SQUARE =
      List.of(
          new Point(-HALF_M, -HALF_M),
          new Point(HALF_M, -HALF_M),
          new Point(HALF_M, HALF_M),
          new Point(-HALF_M, HALF_M));

  private static Body square(double xM, double zM, double turnRad) {
    return Body.of(new Obstacle("o", new Point(xM, zM), turnRad, SQUARE, SHADOW));
  }

  private static Beam beam(double halfDeg) {
    return new Beam(0, Math.toRadians(halfDeg));
  }

  @Test
  void flatSide_isAsNearAsItsFoot() {
    Sight sight = square(1, 0, 0).seenFrom(new Pose(0, 0.03, 0), beam(20), 3);
    assertEquals(3, sight.body());
    assertEquals(0.9, sight.distanceM(), SAMPLING_M);
    assertEquals(0, sight.offAxisRad(), 2e-4);
    assertEquals(Math.hypot(1, 0.03), sight.centreM(), 1e-12);
    assertEquals(2, sight.thresholdM());
    assertTrue(sight.inCone());
  }

  /** Turned by an eighth it shows its corner. */
  @Test
  void corner_isNearerByHalfOfTheDiagonal() {
    Body body = square(1, 0, 0).turned(Math.PI / 4);
    assertEquals(1 - HALF_M * Math.sqrt(2), body.seenFrom(ORIGIN, beam(20), 0).distanceM(), 1e-9);
    assertEquals(
        1 - HALF_M * Math.sqrt(2),
        square(1, 0, Math.PI / 4).seenFrom(ORIGIN, beam(20), 0).distanceM(),
        1e-9);
  }

  /**
   * Turned by 30 degrees the nearest corner is the one at 165 degrees, 0.1414 m from the middle.
   */
  @Test
  void turn_isCounterClockwise() {
    double r = HALF_M * Math.sqrt(2);
    double angle = Math.toRadians(165);
    // A corner at 135 degrees, up and to the left, turned on by 30.
    double x = 1 + r * Math.cos(angle);
    double z = -r * Math.sin(angle);
    Sight sight = square(1, 0, Math.toRadians(30)).seenFrom(ORIGIN, beam(20), 0);
    assertEquals(Math.hypot(x, z), sight.distanceM(), 1e-9);
    assertEquals(Math.atan2(-z, x), sight.offAxisRad(), 1e-9);
  }

  /** A cone from 4 to 14 degrees has the side from 0.9 tan 4 to its end, of which 4 is nearest. */
  @ParameterizedTest
  @ValueSource(doubles = {1, -1})
  void sideAtTheRim_isNearestWhereTheRimMeetsIt(double side) {
    Pose pose = new Pose(0, 0, side * Math.toRadians(9));
    Sight sight = square(1, 0, 0).seenFrom(pose, beam(5), 0);
    double rim = Math.toRadians(4);
    assertEquals(0.9 / Math.cos(rim), sight.distanceM(), SAMPLING_M);
    assertEquals(-side * Math.toRadians(5), sight.offAxisRad(), 3e-4);
    Beam aside = new Beam(side * Math.toRadians(9), Math.toRadians(5));
    Sight other = square(1, 0, 0).seenFrom(ORIGIN, aside, 0);
    assertEquals(sight.distanceM(), other.distanceM(), 1e-12);
    assertEquals(sight.offAxisRad(), other.offAxisRad(), 1e-12);
  }

  /**
   * From a metre before its middle it spans atan(0.1 / 0.9) = 6.34 degrees to either side, so a
   * cone of 10 degrees sees some of it until 16.34, in whatever direction it stands.
   */
  @ParameterizedTest
  @ValueSource(doubles = {0, 90, 170, -135})
  void cone_seesItAsLongAsTheyOverlap(double towardsDeg) {
    double towards = Math.toRadians(towardsDeg);
    Body body = square(Math.cos(towards), -Math.sin(towards), towards);
    for (int beside = -179; beside <= 180; beside++) {
      Pose pose = new Pose(0, 0, towards + Math.toRadians(beside));
      Sight sight = body.seenFrom(pose, beam(10), 0);
      assertEquals(Math.abs(beside) <= 16, sight.inCone(), beside + " degrees");
      if (!sight.inCone()) {
        assertEquals(Double.POSITIVE_INFINITY, sight.distanceM());
        assertEquals(0, sight.offAxisRad());
        assertEquals(1, sight.centreM(), 1e-12);
      }
    }
  }

  /** A sonar so near that the circle round the square holds it sees the side before it only. */
  @Test
  void veryNear_itSeesWhatIsBeforeIt() {
    Body body = square(0.12, 0, 0);
    assertEquals(0.02, body.seenFrom(ORIGIN, beam(15), 0).distanceM(), SAMPLING_M);
    assertFalse(body.seenFrom(new Pose(0, 0, Math.PI), beam(15), 0).inCone());
  }

  /** A bearing is that of the transducer in the square's own frame: 0 along its z, growing to x. */
  @ParameterizedTest
  @CsvSource({"0, 1, 0", "1, 0, 90", "0, -1, 180", "-1, 0, -90"})
  void bearing_isInItsOwnFrame(double xM, double zM, double deg) {
    Pose pose = new Pose(xM, zM, 0);
    double bearing = square(0, 0, 0).seenFrom(pose, beam(15), 0).bearingRad();
    assertEquals(Math.toRadians(deg), bearing, 1e-12);
    double turned = square(0, 0, 0.2).seenFrom(pose, beam(15), 0).bearingRad();
    assertEquals(Math.toRadians(deg) - 0.2, turned, 1e-12);
  }

  /** What is changed is one thing; all others stay, the time of its being there too. */
  @Test
  void copies_keepTheRest() {
    Shadow other = Shadow.uniform(1);
    Body there = square(1, 0, 0).during(2, 5);
    for (Body body : List.of(there, there.moved(0, 0.5), there.turned(1), there.with(other))) {
      assertFalse(body.isThereAt(1.999));
      assertTrue(body.isThereAt(2));
      assertTrue(body.isThereAt(4.999));
      assertFalse(body.isThereAt(5));
    }
    assertTrue(square(1, 0, 0).isThereAt(-1e9) && square(1, 0, 0).isThereAt(1e9));
    assertSame(SHADOW, there.turned(1).shadow());
    assertSame(other, there.with(other).shadow());
    assertEquals(new Point(1.5, -0.25), there.moved(0.5, -0.25).place());
    assertEquals(new Point(1, 0), there.with(other).place());
    Body moved = square(1, 0, 0.3).moved(0.5, 0);
    assertEquals(
        square(1.5, 0, 0.3).seenFrom(ORIGIN, beam(15), 0), moved.seenFrom(ORIGIN, beam(15), 0));
    assertEquals(
        square(1, 0, 0.5).seenFrom(ORIGIN, beam(15), 0),
        square(1, 0, 0.3).turned(0.2).seenFrom(ORIGIN, beam(15), 0));
  }

  @Test
  void obstacle_isHeldByItsCircle() {
    Obstacle obstacle = new Obstacle("o", new Point(5, 5), 0, SQUARE, SHADOW);
    assertEquals(HALF_M * Math.sqrt(2), obstacle.radiusM(), 1e-12);
  }

  /** The chord of a right angle between radii of 1 and 2: 2 / (sin t + 2 sin(90 - t)). */
  @ParameterizedTest
  @CsvSource({"0, 1", "30, 0.8960", "45, 0.9428", "60, 1.0718", "90, 2", "180, 0.5", "-90, 0.25"})
  void shadow_isAPolygon(double deg, double expectedM) {
    Shadow shadow = new Shadow(List.of(1.0, 2.0, 0.5, 0.25));
    assertEquals(expectedM, shadow.atM(Math.toRadians(deg)), 5e-5);
    assertEquals(expectedM, shadow.atM(Math.toRadians(deg + 720)), 5e-5);
  }

  @Test
  void shadow_knowsItsKindAndItsGreatest() {
    Shadow shadow = new Shadow(List.of(1.0, 2.0, 0.5));
    assertFalse(shadow.isUniform());
    assertEquals(2, shadow.greatestM());
    assertTrue(SHADOW.isUniform());
    assertEquals(2, SHADOW.atM(0.7));
    assertEquals(0, new Shadow(List.of(0.0, 0.0, 3.0)).atM(0.5));
    assertEquals(0, Shadow.uniform(0).greatestM());
  }
}
