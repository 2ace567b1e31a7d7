package simbad.scene3d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.media.j3d.Transform3D;
import javax.vecmath.AxisAngle4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Where the eye gets; Transform3D needs no display. */
class ViewpointTest {
  private static final double EPSILON = 1e-9;
  private static final Vector3d UP = new Vector3d(0, 1, 0);

  private final Viewpoint viewpoint = new Viewpoint();

  /** Four metres south of the origin, looking north. */
  private void lookNorth() {
    viewpoint.look(new Point3d(0, 0, 4), new Point3d(), UP);
  }

  private Point3d eye() {
    return seen(new Point3d());
  }

  /** A point given in the eye's frame (x right, y up, z backwards), in the world's. */
  private Point3d seen(Point3d point) {
    Transform3D worldFromEye = new Transform3D();
    viewpoint.get(worldFromEye);
    worldFromEye.transform(point);
    return point;
  }

  private static void check(double x, double y, double z, Point3d actual) {
    assertEquals(0, actual.distance(new Point3d(x, y, z)), EPSILON, actual.toString());
  }

  @Test
  void look_putsTheCentreStraightAhead() {
    viewpoint.look(new Point3d(3, 4, 0), new Point3d(0, 0, 0), UP);
    check(3, 4, 0, eye());
    check(0, 0, 0, seen(new Point3d(0, 0, -5)));
    assertEquals(5, viewpoint.distanceM(), EPSILON);
  }

  @Test
  void orbit_turnsAboutTheVertical() {
    lookNorth();
    viewpoint.orbit(Math.PI / 2, 0);
    check(4, 0, 0, eye());
    check(0, 0, 0, seen(new Point3d(0, 0, -4)));
  }

  @Test
  void orbit_upwards_stopsAboveTheCentre() {
    lookNorth();
    viewpoint.orbit(0, Math.toRadians(30));
    check(0, 2, 4 * Math.cos(Math.toRadians(30)), eye());
    viewpoint.orbit(0, Math.PI);
    check(0, 4, 0, eye());
  }

  @Test
  void orbit_downwards_stopsALittleBelowTheFloor() {
    lookNorth();
    viewpoint.orbit(0, -Math.PI);
    check(0, -4 * Math.sin(Math.toRadians(10)), 4 * Math.cos(Math.toRadians(10)), eye());
  }

  /** However one turns, the centre stays ahead, the horizon level and the distance the same. */
  @Property(tries = 200, seed = "20140914")
  void orbit_keepsCentreHorizonAndDistance(
      @ForAll @DoubleRange(min = -7, max = 7) double about,
      @ForAll @DoubleRange(min = -4, max = 4) double upwards,
      @ForAll @DoubleRange(min = -4, max = 4) double again) {
    Viewpoint turned = new Viewpoint();
    turned.look(new Point3d(1, 2, 3), new Point3d(0, 1, 0), UP);
    turned.orbit(about, upwards);
    turned.orbit(-2 * about, again);
    Transform3D worldFromEye = new Transform3D();
    turned.get(worldFromEye);
    Point3d ahead = new Point3d(0, 0, -Math.sqrt(11));
    worldFromEye.transform(ahead);
    assertEquals(0, ahead.distance(new Point3d(0, 1, 0)), 1e-6);
    Vector3d right = new Vector3d(1, 0, 0);
    worldFromEye.transform(right);
    assertEquals(0, right.y, 1e-6);
  }

  @Test
  void pan_movesEyeAndCentreAcrossTheView() {
    lookNorth();
    viewpoint.pan(0.5, 0.25);
    check(2, 1, 4, eye());
    viewpoint.orbit(Math.PI / 2, 0);
    check(6, 1, 0, eye());
  }

  @Test
  void zoom_changesTheDistance_withinItsLimits() {
    lookNorth();
    viewpoint.zoom(0.5);
    check(0, 0, 2, eye());
    viewpoint.zoom(1e-9);
    assertEquals(0.02, viewpoint.distanceM(), EPSILON);
    viewpoint.zoom(1e9);
    assertEquals(1000, viewpoint.distanceM(), 1e-6);
  }

  @Test
  void goHome_returnsToWhereItLookedLast() {
    lookNorth();
    viewpoint.pan(1, 1);
    viewpoint.orbit(1, 1);
    viewpoint.goHome();
    check(0, 0, 4, eye());
    assertEquals(4, viewpoint.distanceM(), EPSILON);
  }

  @Test
  void anchor_carriesTheEye() {
    lookNorth();
    Transform3D anchor = new Transform3D();
    anchor.rotY(Math.PI / 2);
    anchor.setTranslation(new Vector3d(10, 1, 0));
    viewpoint.setAnchor(anchor);
    check(14, 1, 0, eye());
  }

  @Test
  void setCentre_changesWhatTheEyeTurnsAbout() {
    lookNorth();
    viewpoint.setCentre(new Point3d(0, 0, 2));
    viewpoint.orbit(Math.PI, 0);
    check(0, 0, 0, eye());
  }

  @Test
  void look_takesATransformAsItIs() {
    Transform3D given = new Transform3D();
    given.setTranslation(new Vector3d(1, 2, 3));
    viewpoint.look(given);
    check(1, 2, 3, eye());
  }

  /** Distances as in the original, for a default robot in a default world. */
  @ParameterizedTest
  @EnumSource
  void lookout_isWhereTheOriginalHadIt(Lookout lookout) {
    lookout.place(viewpoint, new Lookout.Sizes(20, 0.5, 0.3));
    Point3d expected =
        switch (lookout) {
          case TOP -> new Point3d(0, 24, 0);
          case EAST -> new Point3d(20, 20, 0);
          case BEHIND -> new Point3d(-2.4, 1.5, 0);
          case ABOVE -> new Point3d(0, 16, 0);
          case ABOVE_NEAR -> new Point3d(0, 5, 0);
          case SIDE -> new Point3d(0, 1, 3);
          // The original had none.
          case INWARDS -> new Point3d(-1.75, 3.75, 0);
        };
    check(expected.x, expected.y, expected.z, eye());
  }

  /** In windows of any shape, with walls of a metre round it. */
  @ParameterizedTest
  @CsvSource({"TOP, 8", "TOP, 20", "TOP, 25", "EAST, 8", "EAST, 20", "EAST, 25"})
  void lookout_hasTheWholeFloorInView(Lookout lookout, double sideM) {
    lookout.place(viewpoint, new Lookout.Sizes(sideM, 0.5, 0.3));
    Transform3D eyeFromWorld = new Transform3D();
    viewpoint.get(eyeFromWorld);
    eyeFromWorld.invert();
    for (double shape : new double[] {0.5, 0.8, 1, 1.3, 1.6, 2.2}) {
      double across = Math.tan(lookout.fieldOfViewRad(600 * shape, 600) / 2);
      for (int i = 0; i < 8; i++) {
        double half = sideM / 2;
        Point3d corner = new Point3d((i & 1) == 0 ? half : -half, i >> 2, (i & 2) - 1);
        corner.z *= half;
        eyeFromWorld.transform(corner);
        assertTrue(Math.abs(corner.x / corner.z) < across, shape + ": " + corner);
        assertTrue(Math.abs(corner.y / corner.z) < across / shape, shape + ": " + corner);
      }
    }
  }

  /** Wherever the agent stands and looks, the eye is farther out than it. */
  @ParameterizedTest
  @CsvSource({"3, 0", "0, 3", "-3, 0", "0, -3", "2, -1"})
  void lookoutInwards_isOutsideOfTheAgent(double xM, double zM) {
    Transform3D agent = new Transform3D();
    agent.rotY(1);
    agent.setTranslation(new Vector3d(xM, 0.15, zM));
    Transform3D anchor = new Transform3D(agent);
    anchor.setRotation(new AxisAngle4d(0, 1, 0, Lookout.INWARDS.anchorTurnRad(agent)));
    Lookout.INWARDS.place(viewpoint, new Lookout.Sizes(8, 0.4, 0.1));
    viewpoint.setAnchor(anchor);
    double out = 1 + 3.5 * 0.4 / Math.hypot(xM, zM);
    check(out * xM, 0.15 + 7.5 * 0.4, out * zM, eye());
  }

  /** An agent is seen as large as in the original. */
  @Test
  void lookoutAtAnAgent_hasTheUsualField() {
    assertEquals(Math.PI / 4, Lookout.BEHIND.fieldOfViewRad(900, 600), EPSILON);
  }

  @Test
  void lookoutFromAbove_hasNorthUp_andKeepsAwayFromLowRobots() {
    Lookout.ABOVE_NEAR.place(viewpoint, new Lookout.Sizes(1, 0.03, 0.03));
    check(0, 0.2, 0, eye());
    check(0, 0.2, -1, seen(new Point3d(0, 1, 0)));
  }

  @Test
  void impossibleSizes_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Lookout.Sizes(0, 1, 1));
    assertThrows(IllegalArgumentException.class, () -> new Lookout.Sizes(1, Double.NaN, 1));
    assertThrows(IllegalArgumentException.class, () -> new Lookout.Sizes(1, 1, -1));
  }
}
