package simbad.sonar.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import simbad.sonar.fixture.Reference;
import simbad.sonar.fixture.Seeded;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.frame.Point;

class ConePropertyTest {
  private static double nearest(Outline outline, Point tip, double headingRad, double halfDeg) {
    return new Cone(Math.toRadians(halfDeg))
        .nearestM(outline, tip.xM(), tip.zM(), Math.cos(headingRad), -Math.sin(headingRad));
  }

  private static Point anyTip(Random random) {
    return new Point(random.nextDouble(-2, 2), random.nextDouble(-2, 2));
  }

  /**
   * Points of the outline inside the cone bound the answer from above; and where there is an
   * answer, a dense point lies within a step of it, so those up to a step beside the cone bound it
   * from below.
   */
  @Seeded
  void nearest_liesBetweenTheBoundsOfDensePoints(
      @ForAll Random random,
      @ForAll @DoubleRange(min = -3.14, max = 3.14) double heading,
      @ForAll @DoubleRange(min = 1, max = 180) double halfDeg) {
    Outline outline = Shapes.any(random, 1.5);
    Point tip = anyTip(random);
    double half = Math.toRadians(halfDeg);
    double step = Reference.stepM(outline);
    double nearest = nearest(outline, tip, heading, halfDeg);
    double upper = Reference.nearestM(outline, tip, heading, half, -1e-9);
    double lower = Reference.nearestM(outline, tip, heading, half, step) - step;
    assertTrue(nearest <= upper + 1e-9, nearest + " > " + upper);
    assertTrue(nearest >= lower, nearest + " < " + lower);
  }

  @Seeded
  void nearest_isTheSame_whenAllIsTurned(
      @ForAll Random random,
      @ForAll @DoubleRange(min = -7, max = 7) double turn,
      @ForAll @DoubleRange(min = 1, max = 180) double halfDeg) {
    Outline outline = Shapes.any(random, 1.5);
    double heading = random.nextDouble(-3, 3);
    double before = nearest(outline, new Point(0, 0), heading, halfDeg);
    double after = nearest(Shapes.turned(outline, turn), new Point(0, 0), heading + turn, halfDeg);
    assertEquals(before, after, 1e-9);
  }

  @Seeded
  void nearest_isTheSame_whenAllIsMirrored(
      @ForAll Random random, @ForAll @DoubleRange(min = 1, max = 180) double halfDeg) {
    Outline outline = Shapes.any(random, 1.5);
    Point tip = anyTip(random);
    double heading = random.nextDouble(-3, 3);
    double before = nearest(outline, tip, heading, halfDeg);
    Point mirrored = new Point(tip.xM(), -tip.zM());
    assertEquals(before, nearest(Shapes.mirrored(outline), mirrored, -heading, halfDeg), 1e-9);
  }

  /** What a narrow cone hears a wider one hears too; the widest hears the whole outline. */
  @Seeded
  void nearest_neverGrows_withTheHalfAngle(@ForAll Random random) {
    Outline outline = Shapes.any(random, 1.5);
    Point tip = anyTip(random);
    double heading = random.nextDouble(-3, 3);
    double before = Double.POSITIVE_INFINITY;
    for (int halfDeg = 1; halfDeg <= 180; halfDeg++) {
      double nearest = nearest(outline, tip, heading, halfDeg);
      assertTrue(nearest <= before + 1e-12, "at " + halfDeg + ": " + nearest + " > " + before);
      before = nearest;
    }
    assertEquals(outline.distanceM(tip.xM(), tip.zM()), before, 1e-12);
  }

  /** The sense of going round and the first corner do not matter. */
  @Seeded
  void nearest_isTheSame_forTheSameLineOtherwiseWritten(@ForAll Random random) {
    Outline outline = Shapes.any(random, 1.5);
    Point tip = anyTip(random);
    double heading = random.nextDouble(-3, 3);
    double before = nearest(outline, tip, heading, 27.5);
    List<Point> corners = new ArrayList<>(outline.corners());
    Collections.reverse(corners);
    Collections.rotate(corners, 2);
    assertEquals(before, nearest(Outline.of(corners), tip, heading, 27.5), 1e-12);
  }

  /** Where a cone misses the disc round an outline it meets nothing of the outline. */
  @Seeded
  void misses_isNeverTrueOfADiscWithAPointInTheCone(
      @ForAll Random random, @ForAll @DoubleRange(min = 0.1, max = 180) double halfDeg) {
    Outline outline = Shapes.any(random, 0.3);
    double radius = outline.reachM(0, 0);
    Point tip = anyTip(random);
    double heading = random.nextDouble(-3, 3);
    double cos = Math.cos(heading);
    double sin = Math.sin(heading);
    double along = -tip.xM() * cos + tip.zM() * sin;
    double across = tip.xM() * sin + tip.zM() * cos;
    if (new Cone(Math.toRadians(halfDeg)).misses(along, across, radius)) {
      assertEquals(Double.POSITIVE_INFINITY, nearest(outline, tip, heading, halfDeg));
    }
  }

  /** A centre at 45 degrees is 15 degrees beyond a border of 30, sin 15 of its distance away. */
  @Test
  void misses_inClosedForm() {
    Cone cone = new Cone(Math.toRadians(30));
    assertFalse(cone.misses(3, 0, 0.01));
    assertTrue(cone.misses(3, 3, 3 * Math.sin(Math.toRadians(15)) * Math.sqrt(2) - 0.01));
    assertFalse(cone.misses(3, -3, 3 * Math.sin(Math.toRadians(15)) * Math.sqrt(2) + 0.01));
    assertTrue(cone.misses(-1, 0, 0.9));
    assertFalse(cone.misses(-1, 0, 1.1));
    assertFalse(new Cone(Math.toRadians(90)).misses(-5, 0, 0.1));
  }

  /** What holds the disc round an outline sees the outline's nearest point. */
  @Seeded
  void holds_seesTheNearestPointOfAll(
      @ForAll Random random, @ForAll @DoubleRange(min = 0.1, max = 180) double halfDeg) {
    Outline outline = Shapes.any(random, 0.3);
    Point tip = anyTip(random);
    double heading = random.nextDouble(-3, 3);
    double cos = Math.cos(heading);
    double sin = Math.sin(heading);
    double along = -tip.xM() * cos + tip.zM() * sin;
    double across = tip.xM() * sin + tip.zM() * cos;
    if (new Cone(Math.toRadians(halfDeg)).holds(along, across, outline.reachM(0, 0))) {
      assertEquals(
          outline.distanceM(tip.xM(), tip.zM()), nearest(outline, tip, heading, halfDeg), 1e-12);
    }
  }

  /** A centre at 15 degrees is 15 degrees within a border of 30, sin 15 of its distance away. */
  @Test
  void holds_inClosedForm() {
    Cone cone = new Cone(Math.toRadians(30));
    double along = Math.cos(Math.toRadians(15));
    double aside = Math.sin(Math.toRadians(15));
    assertTrue(cone.holds(along, aside, aside - 0.01));
    assertFalse(cone.holds(along, -aside, aside + 0.01));
    assertFalse(cone.holds(-3, 0, 0.1));
    assertFalse(new Cone(Math.toRadians(90)).holds(5, 0, 0.1));
  }
}
