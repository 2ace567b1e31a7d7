package simbad.sonar.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.ForAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Seeded;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;

class OverlapTest {
  private static Outline square(double side) {
    return Shapes.square(0, 0, side);
  }

  /** Any polygon that does not cross itself: corners in the order of their bearings. */
  private static Outline anyStar(Random random) {
    int size = random.nextInt(3, 9);
    double[] xz = new double[2 * size];
    double x = random.nextDouble(-0.5, 0.5);
    double z = random.nextDouble(-0.5, 0.5);
    boolean backwards = random.nextBoolean();
    for (int i = 0; i < size; i++) {
      double angle = 2 * Math.PI * (backwards ? size - i : i) / size;
      double radius = random.nextDouble(0.1, 1);
      xz[2 * i] = x + radius * Math.cos(angle);
      xz[2 * i + 1] = z + radius * Math.sin(angle);
    }
    return Shapes.outline(xz);
  }

  private static boolean holds(Outline outline, double x, double z) {
    double turns = 0;
    for (int i = 0; i < outline.size(); i++) {
      int next = (i + 1) % outline.size();
      double from = Math.atan2(outline.zM(i) - z, outline.xM(i) - x);
      double to = Math.atan2(outline.zM(next) - z, outline.xM(next) - x);
      turns += Math.IEEEremainder(to - from, 2 * Math.PI);
    }
    return Math.abs(turns) > Math.PI;
  }

  @Seeded
  void area_agreesWithCountedPoints(@ForAll Random random) {
    Outline one = anyStar(random);
    Outline other = anyStar(random);
    double step = 0.02;
    int both = 0;
    for (double x = -1.5 + step / 2; x < 1.5; x += step) {
      for (double z = -1.5 + step / 2; z < 1.5; z += step) {
        both += holds(one, x, z) && holds(other, x, z) ? 1 : 0;
      }
    }
    double border = (one.perimeterM() + other.perimeterM()) * step;
    assertEquals(both * step * step, Overlap.areaM2(one, other), border);
    assertEquals(Overlap.areaM2(one, other), Overlap.areaM2(other, one), 1e-12);
    assertEquals(Math.abs(one.signedAreaM2()), Overlap.areaM2(one, one), 1e-12);
  }

  /**
   * Their edges lie along each other or end in each other; none crosses another between its ends.
   */
  @ParameterizedTest
  @CsvSource({
    "0, -0.9, 1, 0.1", "0, 0.9, 1, 0.1", "-0.9, 0, 1, 0.1", "0.9, 0, 1, 0.1",
    "0, -1, 1, 0", "0.25, 0, 0.5, 0.25", "0.25, 0.25, 0.5, 0.25", "0, 0.75, 0.5, 0"
  })
  void squares_shareAnArea_whereEdgesLieAlongEachOther(
      double xM, double zM, double side, double expectedM2) {
    Outline other = Shapes.square(xM, zM, side);
    assertEquals(expectedM2, Overlap.areaM2(square(1), other), 1e-15);
    assertEquals(expectedM2 > 0, Overlap.of(square(1), other));
    assertEquals(expectedM2 > 0, Overlap.of(other, square(1)));
  }

  /** A plus of two bars: edges cross and no bar has a corner in the other. */
  @Test
  void bars_shareTheMiddle() {
    Outline flat = Shapes.outline(-2, -0.5, 2, -0.5, 2, 0.5, -2, 0.5);
    Outline tall = Shapes.outline(-0.5, 2, -0.5, -2, 0.5, -2, 0.5, 2);
    assertEquals(1, Overlap.areaM2(flat, tall), 1e-15);
  }

  /** Rounding makes turned neighbours cross by a hair. */
  @Test
  void turnedNeighbours_onlyTouch() {
    for (int degrees = 0; degrees < 360; degrees++) {
      Placement turned = new Placement(3, 4, Math.toRadians(degrees));
      Outline one = Shapes.square(0, 0, 0.3).placed(turned);
      Outline other = Shapes.square(0.3, 0.1, 0.3).placed(turned);
      assertFalse(Overlap.of(one, other), degrees + " degrees");
    }
  }

  /** A square of 1 m beside one of another size that is moved along x. */
  @ParameterizedTest
  @CsvSource({
    "0.9, 1, true",
    "1.1, 1, false",
    "1, 1, false",
    "0, 0.2, true",
    "0, 3, true",
    "0, 1, true",
    "0.65, 0.2, false"
  })
  void squares_overlapWhenTheyCrossOrHold(double shiftM, double side, boolean expected) {
    Outline other = square(side).placed(new Placement(shiftM, 0, 0));
    assertEquals(expected, Overlap.of(square(1), other));
    assertEquals(expected, Overlap.of(other, square(1)));
  }

  /** Turned by an eighth its corner reaches 0.707 m. */
  @Test
  void turning_counts() {
    Outline turned = square(1).placed(new Placement(1.15, 0, Math.PI / 4));
    assertTrue(Overlap.of(square(1), turned));
    assertFalse(Overlap.of(square(1), square(1).placed(new Placement(1.25, 0, Math.PI / 4))));
  }

  /**
   * A dent whose tip lies on another edge, and a spike along one: edge and tip in every order. No
   * two edges cross between their ends.
   */
  @Test
  void touching_isFound_whicheverCornerTouches() {
    Outline dent = Shapes.outline(0, 0, 4, 0, 4, 2, 3, 2, 2, 0, 1, 2, 0, 2);
    Outline apart = Shapes.outline(0, 0, 4, 0, 4, 2, 3, 2, 2, 0.1, 1, 2, 0, 2);
    Outline besides = Shapes.outline(0, 0, 4, 0, 4, 2, 9, 2, 9, -2, 5, 0, 6, -3, 0, -3);
    for (int first = 0; first < 8; first++) {
      assertTrue(Crossing.find(from(dent, first)).isPresent(), "from corner " + first);
      assertTrue(Crossing.find(from(Shapes.mirrored(dent), first)).isPresent());
      assertTrue(Crossing.find(from(Shapes.turned(dent, Math.PI), first)).isPresent());
      assertEquals(Optional.empty(), Crossing.findCrossed(from(dent, first)));
      assertEquals(Optional.empty(), Crossing.find(from(apart, first)));
      assertEquals(Optional.empty(), Crossing.find(from(besides, first)), "on an edge's line");
    }
  }

  private static Outline from(Outline outline, int first) {
    List<Point> corners = new ArrayList<>(outline.corners());
    Collections.rotate(corners, first);
    return Outline.of(corners);
  }

  /** A bow tie crosses itself; two bodies joined by a line only touch. */
  @Test
  void crossing_isNotTouching() {
    Outline bow =
        Outline.of(List.of(new Point(0, 0), new Point(1, 1), new Point(1, 0), new Point(0, 1)));
    assertEquals(Optional.of(new Crossing(0, 2)), Crossing.find(bow));
    assertEquals(Optional.of(new Crossing(0, 2)), Crossing.findCrossed(bow));
    Outline pair = Outline.joined(List.of(square(1), square(1).placed(new Placement(3, 0, 0))));
    assertTrue(Crossing.find(pair).isPresent());
    assertEquals(Optional.empty(), Crossing.findCrossed(pair));
    assertEquals(Optional.empty(), Crossing.find(square(1)));
  }
}
