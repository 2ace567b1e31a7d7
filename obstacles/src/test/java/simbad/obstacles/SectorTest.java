package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The tests' own overlap test, tested. */
class SectorTest {
  private static final Sector EAST = new Sector(0, 0, 0, Math.toRadians(30), 2);

  @ParameterizedTest
  @CsvSource({
    // in the sector; round the apex; across it; beyond the arc; behind; beside; through the arc
    "1, 0, 1.1, 0, 1, 0.1, true",
    "-1, -1, 1, -1, 0, 5, true",
    "1, -5, 1.2, -5, 1.1, 5, true",
    "2.1, -1, 3, -1, 2.1, 1, false",
    "-0.1, 0, -1, 1, -1, -1, false",
    "1, 1, 2, 2, 1, 2, false",
    "1.99, 0, 3, 0.1, 3, -0.1, true",
    // A side as a chord of the arc: 1.9 away in the middle, its ends further than 2.
    "1.9, -0.9, 1.9, 0.9, 5, 0, true",
  })
  void overlaps_simpleTriangles(
      double ax, double az, double bx, double bz, double cx, double cz, boolean expected) {
    double[] a = {ax, az};
    double[] b = {bx, bz};
    double[] c = {cx, cz};
    assertEquals(expected, EAST.overlaps(a, b, c));
    assertEquals(expected, EAST.overlaps(b, c, a));
    assertEquals(expected, EAST.overlaps(c, b, a));
  }

  /** Whenever a point of a triangle is in the sector, by sampling, the exact test says so too. */
  @Test
  void overlaps_whereverASampleDoes() {
    Random random = new Random(3);
    int sampled = 0;
    int exact = 0;
    for (int i = 0; i < 2000; i++) {
      double[][] t = new double[3][];
      for (int k = 0; k < 3; k++) {
        t[k] = new double[] {random.nextDouble(-4, 4), random.nextDouble(-4, 4)};
      }
      boolean seen = sampleIsInSector(t, random);
      boolean found = EAST.overlaps(t[0], t[1], t[2]);
      assertTrue(found || !seen, "triangle " + i);
      sampled += seen ? 1 : 0;
      exact += found ? 1 : 0;
    }
    // Samples miss slivers only.
    assertTrue(sampled > 300 && exact < 1.1 * sampled, sampled + " of " + exact);
  }

  private static boolean sampleIsInSector(double[][] t, Random random) {
    for (int i = 0; i < 300; i++) {
      double u = random.nextDouble();
      double v = random.nextDouble();
      double s = u + v > 1 ? 1 - u : u;
      double r = u + v > 1 ? 1 - v : v;
      double x = t[0][0] + s * (t[1][0] - t[0][0]) + r * (t[2][0] - t[0][0]);
      double z = t[0][1] + s * (t[1][1] - t[0][1]) + r * (t[2][1] - t[0][1]);
      if (Math.hypot(x, z) < 2 && Math.abs(Math.atan2(z, x)) < Math.toRadians(30)) {
        return true;
      }
    }
    return false;
  }
}
