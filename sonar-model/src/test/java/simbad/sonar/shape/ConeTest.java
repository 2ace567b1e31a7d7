package simbad.sonar.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Shapes;

class ConeTest {
  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double EXACT = 1e-12;

  /** The square [1.5, 2.5] x [-0.5, 0.5]: seen from (0, 0) it spans atan(1/3) = 18.43 degrees. */
  private static final Outline AHEAD = Shapes.square(2, 0, 1);

  private static void check(
      double expected, Outline outline, double headingDeg, double halfAngleDeg) {
    check(expected, outline, 0, 0, headingDeg, halfAngleDeg);
  }

  private static void check(
      double expected,
      Outline outline,
      double tipX,
      double tipZ,
      double headingDeg,
      double halfAngleDeg) {
    double heading = Math.toRadians(headingDeg);
    double nearest =
        new Cone(Math.toRadians(halfAngleDeg))
            .nearestM(outline, tipX, tipZ, Math.cos(heading), -Math.sin(heading));
    assertEquals(expected, nearest, EXACT, "heading " + headingDeg + " half " + halfAngleDeg);
  }

  private static double cos(double degrees) {
    return Math.cos(Math.toRadians(degrees));
  }

  @Test
  void nearest_isTheFoot_whenTheFootIsInTheCone() {
    check(1.5, AHEAD, 0, 27.5);
    check(1.5, AHEAD, 0, 1);
    check(1.5, AHEAD, 27.4, 27.5);
    check(1.5, AHEAD, -27.4, 27.5);
  }

  /** The border at h - half degrees meets the face x = 1.5 at 1.5 / cos(h - half). */
  @ParameterizedTest
  @CsvSource({"40, 27.5", "45, 27.5", "-45, 27.5", "11, 1", "-19, 1", "100, 90", "160, 150"})
  void nearest_isWhereTheBorderMeetsTheEdge_whenTheFootIsBeside(double heading, double half) {
    check(1.5 / cos(Math.abs(heading) - half), AHEAD, heading, half);
  }

  /**
   * The edge's direction is the border's, to the last bit; what meets the border is another edge.
   */
  @Test
  void edge_besideTheBorder_hasNoPointOnIt() {
    double half = Math.toRadians(27.5);
    double c = Math.cos(half);
    double s = Math.sin(half);
    Outline beside = Shapes.outline(1, 2, 1 + c, 2 + s, 1, 5);
    assertEquals(NONE, new Cone(half).nearestM(beside, 0, 0, 1, 0));
  }

  @Test
  void nothing_isInTheCone() {
    check(NONE, AHEAD, 47, 27.5);
    check(NONE, AHEAD, -47, 27.5);
    check(NONE, AHEAD, 180, 27.5);
    check(NONE, AHEAD, 180, 90);
    check(NONE, AHEAD, 20, 1);
    // The line of the edge x = -1 meets both borders behind the tip only.
    check(NONE, Shapes.square(-2, 0, 2), 0, 27.5);
  }

  /** A thin needle: its near end is in the cone, its foot is not a point of it. */
  @Test
  void nearest_isAnEnd_whenTheEdgeRunsAway() {
    check(2, Shapes.outline(2, 0, 3, 0.2, 3, -0.2), 0, 27.5);
    check(Math.sqrt(2), Shapes.outline(1, 1, 3, 2, 2, 3), -45, 10);
  }

  @Test
  void wideCones_reachBackwards() {
    check(1.5, AHEAD, 180, 180);
    check(1.5, AHEAD, 77, 180);
    // All but a wedge of 10 degrees to either side of +x: the border cuts the face there.
    check(1.5 / cos(10), AHEAD, 180, 170);
    // All but a wedge of 18 degrees: a sliver of the face is left at either end.
    check(1.5 / cos(18), AHEAD, 180, 162);
    // All but a wedge of 20 degrees: the whole square is in the wedge.
    check(NONE, AHEAD, 180, 160);
  }

  @Test
  void tipInside_seesTheInnerSide() {
    Outline square = Shapes.square(0, 0, 1);
    check(0.5, square, 0, 1);
    check(0.5, square, 180, 27.5);
    // From the middle towards the corner: the border nearest to a face is at 44 degrees.
    check(0.5 / cos(44), square, 45, 1);
    check(0.25, square, 0.25, 0, 0, 27.5);
    check(0.75, square, 0.25, 0, 180, 27.5);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 37, 90, 180, -90, -135})
  void tipOnTheOutline_isAtDistance0_whereverItLooks(double heading) {
    check(0, AHEAD, 1.5, 0, heading, 27.5);
    check(0, AHEAD, 2, -0.5, heading, 1);
    check(0, AHEAD, 1.5, 0.5, heading, 1);
    check(0, AHEAD, 1.5, -0.5, heading, 180);
  }

  @Test
  void degenerateEdges_areHeardLikeOthers() {
    Outline repeated =
        Shapes.outline(1.5, -0.5, 1.5, -0.5, 1.5, 0.5, 1.5, 0.5, 2.5, 0.5, 2.5, -0.5);
    check(1.5, repeated, 0, 27.5);
    check(1.5 / cos(12.5), repeated, 40, 27.5);
    // A wall without thickness: there and back on one line.
    Outline wall = Shapes.outline(2, -1, 2, 1, 2, 0);
    check(2, wall, 0, 5);
    check(2 / cos(15), wall, 20, 5);
    // Seen along itself it is a point.
    check(1, wall, 2, 2, 90, 5);
    check(NONE, wall, 2, 2, -90, 5);
  }

  @Test
  void edgeThroughTheTip_isAtDistance0() {
    check(0, Shapes.outline(-1, -1, 1, 1, 2, -3), 90, 10);
  }

  /**
   * A needle whose tip lies at 1 m on the border and the rest of it beside the cone: the border
   * belongs to the cone, at every half angle, on both sides, whatever the rounding.
   */
  @Test
  void cornerOnTheBorder_isInTheCone() {
    for (int half = 1; half <= 170; half++) {
      for (double heading = -180; heading < 180; heading += 7.3) {
        check(1, needle(heading + half, 3), heading, half);
        check(1, needle(heading - half, -3), heading, half);
      }
    }
  }

  /** Where the cone is so thin that its borders are one line, what lies behind is on that line. */
  @Test
  void behindAThinCone_isNotInTheCone() {
    check(1.5, AHEAD, 0, 5e-12);
    check(NONE, AHEAD, 180, 5e-12);
  }

  /** A triangle with a corner at 1 m and the others at 2 m, further off by some degrees. */
  private static Outline needle(double atDeg, double furtherDeg) {
    double a = Math.toRadians(atDeg);
    double b = Math.toRadians(atDeg + furtherDeg);
    double c = Math.toRadians(atDeg + 2 * furtherDeg);
    return Shapes.outline(
        Math.cos(a),
        -Math.sin(a),
        2 * Math.cos(b),
        -2 * Math.sin(b),
        2 * Math.cos(c),
        -2 * Math.sin(c));
  }

  /** An edge that runs out along the border from 1 m: its near end counts. */
  @Test
  void edgeAlongTheBorder_isInTheCone() {
    for (int half = 1; half <= 170; half++) {
      double a = Math.toRadians(half);
      double b = Math.toRadians(half + 5);
      Outline outline =
          Shapes.outline(
              Math.cos(a),
              -Math.sin(a),
              2 * Math.cos(a),
              -2 * Math.sin(a),
              2 * Math.cos(b),
              -2 * Math.sin(b));
      check(1, outline, 0, half);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -0.1, 3.1415926535898, 1e9, Double.NaN, Double.POSITIVE_INFINITY})
  void halfAngle_outOfItsDomain_isRefused(double bad) {
    Refusal.check(() -> new Cone(bad), "halfAngleRad = " + bad, "(0, pi]");
  }

  @Test
  void halfAngle_isKept() {
    assertEquals(0.48, new Cone(0.48).halfAngleRad());
  }
}
