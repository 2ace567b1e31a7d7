package simbad.sonar.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Reference;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Seeded;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;

class OutlineTest {
  private static final Outline SQUARE = Shapes.square(0, 0, 2);

  /** A place, its distance from the line of the square [-1, 1] x [-1, 1], and its reach. */
  @ParameterizedTest
  @CsvSource({
    "0, 0, 1, 1.4142135623731", "3, 0, 2, 4.1231056256177", "0.5, 0, 0.5, 1.8027756377320",
    "1, 1, 0, 2.8284271247462", "1, 0.3, 0, 2.3853720883753", "4, 5, 5, 7.8102496759067"
  })
  void distanceAndReach_ofTheSquare(double x, double z, double distance, double reach) {
    assertEquals(distance, SQUARE.distanceM(x, z), 1e-12);
    assertEquals(reach, SQUARE.reachM(x, z), 1e-12);
  }

  /** Corners from (1, 1) to (4, 5); the sense decides the sign, the place nothing. */
  @Test
  void reachAndArea_ofATriangleBesideTheOrigin() {
    Outline triangle = Shapes.outline(1, 1, 4, 1, 4, 5);
    assertEquals(5, triangle.reachM(1, 1), 1e-15);
    assertEquals(Math.sqrt(41), triangle.reachM(0, 0), 1e-15);
    assertEquals(6, Math.abs(triangle.signedAreaM2()), 1e-12);
    assertEquals(-triangle.signedAreaM2(), Shapes.mirrored(triangle).signedAreaM2(), 1e-12);
  }

  @Seeded
  void distance_agreesWithDensePoints(@ForAll Random random) {
    Outline outline = Shapes.any(random, 1);
    Point from = new Point(random.nextDouble(-2, 2), random.nextDouble(-2, 2));
    double dense = Reference.nearestM(outline, from, 0, Math.PI, 0);
    double distance = outline.distanceM(from.xM(), from.zM());
    assertTrue(distance <= dense + 1e-12, distance + " > " + dense);
    assertEquals(dense, distance, Reference.stepM(outline));
  }

  @Test
  void placed_turnsAndMovesEveryCorner() {
    // A quarter turn counter-clockwise takes +x to -z.
    Outline placed =
        Shapes.outline(0, 0, 2, 0, 2, 1).placed(new Placement(10, 20, Math.toRadians(90)));
    List<Point> expected = List.of(new Point(10, 20), new Point(10, 18), new Point(11, 18));
    for (int i = 0; i < 3; i++) {
      assertEquals(0, expected.get(i).distanceM(placed.corners().get(i)), 1e-12, "corner " + i);
      assertEquals(placed.corners().get(i), new Point(placed.xM(i), placed.zM(i)));
    }
  }

  @Test
  void perimeter_closesTheLine() {
    assertEquals(8, SQUARE.perimeterM(), 1e-15);
    assertEquals(12, Shapes.outline(0, 0, 3, 0, 3, 4).perimeterM(), 1e-15);
  }

  @Test
  void corners_areCopied() {
    List<Point> corners = new ArrayList<>(SQUARE.corners());
    Outline outline = Outline.of(corners);
    corners.set(0, new Point(9, 9));
    assertEquals(SQUARE, outline);
    assertEquals(4, outline.size());
  }

  @Test
  void equality_isByCorners() {
    Outline same = Shapes.square(0, 0, 2);
    assertEquals(SQUARE, same);
    assertEquals(SQUARE.hashCode(), same.hashCode());
    assertNotEquals(SQUARE, Shapes.square(0, 0.1, 2));
    assertNotEquals(SQUARE, Shapes.square(0.1, 0, 2));
    assertNotEquals(SQUARE, (Object) "square");
    assertTrue(SQUARE.toString().contains("-1.0"), SQUARE.toString());
  }

  @Test
  void corners_thatEncloseNothing_areRefused() {
    Refusal.check(() -> Outline.of(List.of()), "corners = 0", "at least 3");
    Refusal.check(() -> Shapes.outline(0, 0, 1, 1), "corners = 2", "at least 3");
    Refusal.check(() -> Shapes.outline(1, 2, 1, 2, 1, 2), "corners all lie at", "1.0", "2.0");
  }
}
