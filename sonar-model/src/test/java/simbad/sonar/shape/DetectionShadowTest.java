package simbad.sonar.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Reference;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Seeded;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.frame.Point;

class DetectionShadowTest {
  private static final double HEIGHT = 0.3;

  /** A place is in the shadow when the polygon's radius at its bearing reaches it. */
  @Seeded
  void contains_isByTheRadius(@ForAll Random random) {
    ThresholdTable table = Shapes.anyTable(random, random.nextInt(3, 80), false);
    DetectionShadow shadow = new DetectionShadow(table);
    double bearing = random.nextDouble(0, 6.28);
    double radius = Reference.polygonRadiusM(table.valuesM(), bearing);
    assertTrue(shadow.contains(at(radius * 0.999999, bearing)), "just inside");
    assertTrue(shadow.contains(at(radius * 0.1, bearing)), "deep inside");
    assertFalse(shadow.contains(at(radius * 1.000001, bearing)), "just outside");
  }

  private static Point at(double distance, double bearing) {
    return new Point(distance * Math.sin(bearing), distance * Math.cos(bearing));
  }

  @Test
  void contains_itsEdgeAndItsCentre() {
    DetectionShadow shadow = new DetectionShadow(ThresholdTable.uniform(4, 2));
    assertTrue(shadow.contains(new Point(0, 2)));
    assertTrue(shadow.contains(new Point(0, 0)));
  }

  @Test
  void contains_nothing_whereTheThresholdIs0() {
    DetectionShadow none = new DetectionShadow(ThresholdTable.uniform(72, 0));
    assertFalse(none.contains(new Point(0, 0)));
    assertFalse(none.contains(new Point(0.1, 0)));
    DetectionShadow half = new DetectionShadow(ThresholdTable.of(1, 1, 0, 0));
    assertTrue(half.contains(new Point(0.3, 0.3)));
    assertFalse(half.contains(new Point(-0.001, -0.001)));
  }

  @Test
  void edge_isTheTablesPoints_andNoneWhenAllAre0() {
    ThresholdTable table = Shapes.anyTable(new Random(5), 72, true);
    assertEquals(table.points(), new DetectionShadow(table).edge().orElseThrow().corners());
    assertTrue(new DetectionShadow(ThresholdTable.uniform(72, 0)).edge().isEmpty());
    assertSame(table, new DetectionShadow(table).table());
  }

  /** The first triangle of each cell is of the floor, the second of the ceiling. */
  @Test
  void triangles_standOnTheFloor() {
    double[] prism = new DetectionShadow(ThresholdTable.uniform(4, 2)).triangles(HEIGHT);
    int cell = prism.length / 4;
    for (int from = 0; from < prism.length; from += cell) {
      for (int vertex = 0; vertex < 3; vertex++) {
        assertEquals(0, prism[from + 3 * vertex + 1]);
        assertEquals(HEIGHT, prism[from + 9 + 3 * vertex + 1]);
      }
    }
  }

  /**
   * Floor and ceiling have the polygon's area, n triangles of T(i) T(i+1) sin(360/n) / 2 each; the
   * wall has the edge's length times the height.
   */
  @ParameterizedTest
  @ValueSource(ints = {3, 36, 72, 360})
  void triangles_haveTheAreaOfThePrism(int size) {
    ThresholdTable table = Shapes.anyTable(new Random(size), size, false);
    double polygon = 0;
    for (int i = 0; i < size; i++) {
      double next = table.valueM((i + 1) % size);
      polygon += table.valueM(i) * next * Math.sin(2 * Math.PI / size) / 2;
    }
    double[] area = areas(new DetectionShadow(table).triangles(HEIGHT));
    assertEquals(polygon, area[0], 1e-9, "floor");
    assertEquals(polygon, area[1], 1e-9, "ceiling");
    double wall = Outline.of(table.points()).perimeterM() * HEIGHT;
    assertEquals(wall, area[2], 1e-9, "wall");
  }

  /** The areas of the triangles that lie at the bottom, at the top, and of the others. */
  private static double[] areas(double[] xyz) {
    double[] sums = new double[3];
    for (int at = 0; at < xyz.length; at += 9) {
      double sum = xyz[at + 1] + xyz[at + 4] + xyz[at + 7];
      int kind = sum == 0 ? 0 : sum == 3 * HEIGHT || Math.abs(sum - 3 * HEIGHT) < 1e-12 ? 1 : 2;
      sums[kind] += area(xyz, at);
    }
    return sums;
  }

  /** Half the length of the cross product of two sides. */
  private static double area(double[] xyz, int at) {
    double[] u = new double[3];
    double[] v = new double[3];
    for (int i = 0; i < 3; i++) {
      u[i] = xyz[at + 3 + i] - xyz[at + i];
      v[i] = xyz[at + 6 + i] - xyz[at + i];
    }
    double x = u[1] * v[2] - u[2] * v[1];
    double y = u[2] * v[0] - u[0] * v[2];
    double z = u[0] * v[1] - u[1] * v[0];
    return Math.sqrt(x * x + y * y + z * z) / 2;
  }

  /** The mesh is closed: every side of a triangle is a side of exactly one other. */
  @Test
  void triangles_encloseThePrism() {
    double[] xyz = new DetectionShadow(Shapes.anyTable(new Random(2), 36, false)).triangles(HEIGHT);
    Map<Set<List<Double>>, Integer> sides = new HashMap<>();
    for (int triangle = 0; triangle < xyz.length / 9; triangle++) {
      for (int i = 0; i < 3; i++) {
        List<Double> from = vertex(xyz, 3 * triangle + i);
        List<Double> to = vertex(xyz, 3 * triangle + (i + 1) % 3);
        sides.merge(Set.of(from, to), 1, Integer::sum);
      }
    }
    assertEquals(Set.of(2), Set.copyOf(sides.values()));
  }

  private static List<Double> vertex(double[] xyz, int vertex) {
    return List.of(xyz[3 * vertex], xyz[3 * vertex + 1], xyz[3 * vertex + 2]);
  }

  /** Every vertex is the centre or exactly (T sin b, T cos b), at the floor or at the height. */
  @Test
  void vertices_areTheTablesPoints() {
    ThresholdTable table = Shapes.anyTable(new Random(1), 72, true);
    double[] xyz = new DetectionShadow(table).triangles(HEIGHT);
    assertEquals(72 * 4 * 9, xyz.length);
    for (int vertex = 0; vertex < xyz.length / 3; vertex++) {
      Point found = new Point(xyz[3 * vertex], xyz[3 * vertex + 2]);
      int cell = vertex / 12;
      boolean known =
          found.equals(new Point(0, 0))
              || found.equals(table.points().get(cell))
              || found.equals(table.points().get((cell + 1) % 72));
      assertTrue(known, "vertex " + vertex + " at " + found);
      assertTrue(xyz[3 * vertex + 1] == 0 || xyz[3 * vertex + 1] == HEIGHT);
    }
    double bearing = Math.toRadians(35);
    double threshold = table.valueM(7);
    assertEquals(threshold * Math.sin(bearing), xyz[7 * 36 + 3], 1e-15);
    assertEquals(threshold * Math.cos(bearing), xyz[7 * 36 + 5], 1e-15);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void height_outOfItsDomain_isRefused(double bad) {
    DetectionShadow shadow = new DetectionShadow(ThresholdTable.uniform(3, 1));
    Refusal.check(() -> shadow.triangles(bad), "heightM = " + bad, "(0, infinity)");
  }
}
