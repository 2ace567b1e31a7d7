package simbad.blindworld.design;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Setup;

/** Scenes and set-ups over many draws. */
class DrawnScenesTest {

  private static final int DRAWS = 400;

  private static List<Scene> scenes() {
    return IntStream.range(0, DRAWS).mapToObj(seed -> Scenes.draw(new Chance(seed), 0.1)).toList();
  }

  private static List<Obstacle> obstacles(String kind) {
    List<Obstacle> all =
        scenes().stream()
            .flatMap(s -> s.obstacles().stream())
            .filter(o -> o.name().replaceAll("[0-9]", "").equals(kind))
            .toList();
    assertTrue(all.size() > 50, all.size() + " of " + kind);
    return all;
  }

  private static void assertWithin(double least, double most, double value) {
    assertTrue(value >= least && value <= most, least + " " + value + " " + most);
  }

  /** Of a half-degree grid in 12 to 30 degrees, and so on: what a maker's page says. */
  @Test
  void sensor_isDrawnFromItsGrids() {
    Set<String> names = new HashSet<>();
    int beyond = 0;
    for (Scene scene : scenes()) {
      Sensor sensor = scene.sensor();
      names.add(sensor.name());
      double half = 2 * Math.toDegrees(sensor.halfAngleRad());
      assertEquals(Math.rint(half), half, 1e-9);
      assertWithin(24, 60.5, half);
      assertWithin(0.0199, 0.0601, sensor.minRangeM());
      assertWithin(3, 6, sensor.maxRangeM());
      assertWithin(0.0599, 0.3501, sensor.mountHeightM());
      assertWithin(0.00199, 0.01001, sensor.rangeNoiseM());
      assertWithin(0, 0.02501, sensor.missRate());
      assertWithin(0.00999, 0.04001, sensor.edgeWidthM());
      assertWithin(331.5, 346, sensor.soundSpeedMPerS());
      assertWithin(0.005, 0.02, sensor.resolutionM());
      assertEquals(0.1, sensor.periodS());
      double more = scene.noEchoM() - sensor.maxRangeM();
      assertTrue(more == 0 || more == 0.5, more + " m");
      beyond += more > 0 ? 1 : 0;
    }
    assertEquals(5, names.size());
    // A quarter, give or take five standard errors of 0.0217.
    assertEquals(0.25, beyond / (double) DRAWS, 0.11);
  }

  /** One in 3 of 6, two in 2 of 6, three in 1 of 6; more than 55 cm apart, in whole centimetres. */
  @Test
  void obstacles_standApart() {
    Map<Integer, Integer> counts = new HashMap<>();
    for (Scene scene : scenes()) {
      List<Obstacle> all = scene.obstacles();
      counts.merge(all.size(), 1, Integer::sum);
      for (int i = 0; i < all.size(); i++) {
        Point place = all.get(i).place();
        assertTrue(all.get(i).name().endsWith(String.valueOf(i + 1)), all.get(i).name());
        assertWithin(-1.1001, 1.1001, place.xM());
        assertWithin(-1.1001, 1.1001, place.zM());
        assertEquals(Math.rint(100 * place.xM()), 100 * place.xM(), 1e-9);
        assertEquals(Math.rint(100 * place.zM()), 100 * place.zM(), 1e-9);
        for (int k = 0; k < i; k++) {
          Point other = all.get(k).place();
          assertTrue(
              Math.hypot(place.xM() - other.xM(), place.zM() - other.zM()) > 0.55,
              scene.toString());
        }
      }
    }
    assertEquals(Set.of(1, 2, 3), counts.keySet());
    assertEquals(0.5, counts.getOrDefault(1, 0) / (double) DRAWS, 0.13);
    assertEquals(1 / 6.0, counts.getOrDefault(3, 0) / (double) DRAWS, 0.1);
  }

  private static double[] radii(Obstacle obstacle) {
    return obstacle.outline().stream().mapToDouble(p -> Math.hypot(p.xM(), p.zM())).toArray();
  }

  private static void assertRegular(String kind, int least, int most, double leastM, double mostM) {
    for (Obstacle obstacle : obstacles(kind)) {
      int corners = obstacle.outline().size();
      assertWithin(least, most, corners);
      double radius = radii(obstacle)[0];
      assertWithin(leastM - 1e-4, mostM + 1e-4, radius);
      for (int i = 0; i < corners; i++) {
        Point p = obstacle.outline().get(i);
        assertEquals(radius, radii(obstacle)[i], 2e-4);
        double angle = Math.PI * (2 * i + 1) / corners;
        assertEquals(radius * Math.cos(angle), p.xM(), 2e-4, kind);
        assertEquals(radius * Math.sin(angle), p.zM(), 2e-4, kind);
      }
    }
  }

  /** Corners at even angles, the first one half a step from x. */
  @Test
  void regularOnes_haveEvenCorners() {
    assertRegular("round", 16, 39, 0.008, 0.06);
    assertRegular("square", 4, 4, 0.01, 0.07);
    assertRegular("hexagon", 6, 6, 0.02, 0.09);
    assertRegular("triangle", 3, 3, 0.02, 0.08);
  }

  @Test
  void plates_andAngles_areThin() {
    for (Obstacle plate : obstacles("plate")) {
      List<Point> p = plate.outline();
      double half = p.get(1).xM();
      double thick = 2 * p.get(2).zM();
      assertWithin(0.0499, 0.3001, half);
      assertWithin(0.0038, 0.0302, thick);
      assertEquals(
          List.of(
              new Point(-half, -thick / 2),
              new Point(half, -thick / 2),
              new Point(half, thick / 2),
              new Point(-half, thick / 2)),
          p);
    }
    for (Obstacle angle : obstacles("angle")) {
      List<Point> p = angle.outline();
      assertEquals(6, p.size());
      double half = p.get(1).xM();
      double wall = half - p.get(3).xM();
      assertWithin(0.0099, 0.0401, half);
      assertWithin(0.06 * 2 * half - 3e-4, 0.2 * 2 * half + 3e-4, wall);
      double[][] expected = {
        {-half, -half},
        {half, -half},
        {half, half},
        {half - wall, half},
        {half - wall, wall - half},
        {-half, wall - half},
      };
      for (int i = 0; i < 6; i++) {
        assertEquals(expected[i][0], p.get(i).xM(), 2e-4);
        assertEquals(expected[i][1], p.get(i).zM(), 2e-4);
      }
    }
  }

  /** In steps of 1 or 2 cm, from 4 cm to 3.4 m; a fifth is believed the same all round. */
  @Test
  void thresholds_areRounded() {
    int uniform = 0;
    int all = 0;
    for (Scene scene : scenes()) {
      for (Obstacle obstacle : scene.obstacles()) {
        all++;
        uniform += obstacle.shadow().isUniform() ? 1 : 0;
        for (double radius : obstacle.shadow().radiiM()) {
          assertEquals(Math.rint(100 * radius), 100 * radius, 1e-9);
          assertWithin(0.0399, 3.4001, radius);
          if (obstacle.shadow().isUniform()) {
            assertEquals(Math.rint(20 * radius), 20 * radius, 1e-9);
            assertWithin(0.9, 2.8001, radius);
          }
        }
        double deg = Math.toDegrees(obstacle.turnRad());
        assertEquals(Math.rint(deg), deg, 1e-9);
        assertWithin(-180, 179.1, deg);
      }
    }
    assertEquals(0.2, uniform / (double) all, 0.09);
  }

  /**
   * The mean of what a table has opposite at an angle, by its waves: cos of n times the bearing.
   */
  private static double wave(List<Double> radii, int n) {
    double re = 0;
    double im = 0;
    for (int i = 0; i < radii.size(); i++) {
      double a = 2 * Math.PI * n * i / radii.size();
      re += radii.get(i) * Math.cos(a);
      im += radii.get(i) * Math.sin(a);
    }
    return Math.hypot(re, im) / radii.size();
  }

  private static void assertWaves(String kind, int sides) {
    int tables = 0;
    for (Obstacle obstacle : obstacles(kind)) {
      List<Double> radii = obstacle.shadow().radiiM();
      if (!obstacle.shadow().isUniform() && radii.size() > 30) {
        tables++;
        for (int n = 1; n < 7; n++) {
          if (n != sides) {
            assertTrue(wave(radii, n) < wave(radii, sides) + 0.06, kind + " " + n);
          }
        }
        assertTrue(wave(radii, sides) > 0.02, kind + " " + radii);
      }
    }
    assertTrue(tables > 20, tables + " tables");
  }

  /** A table has as many lobes as there are sides. */
  @Test
  void tables_haveTheLobesOfTheirSides() {
    assertWaves("square", 4);
    assertWaves("hexagon", 6);
    assertWaves("triangle", 3);
    assertWaves("plate", 2);
    for (Obstacle round : obstacles("round")) {
      double mean = wave(round.shadow().radiiM(), 0);
      assertWithin(0.85, 2.85, mean);
      if (!round.shadow().isUniform()) {
        for (double radius : round.shadow().radiiM()) {
          assertWithin(mean * (1 - 0.15 - 0.1) - 0.02, mean * (1 + 0.15 + 0.1) + 0.02, radius);
        }
      }
    }
  }

  /** A little more of everything than a sensor says. */
  @Test
  void setUp_isALittleOff() {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 4, 0.15, 343, 0.01, 0.004, 0.01, 0.03, 0.1);
    for (int seed = 0; seed < DRAWS; seed++) {
      Setup off = Scenes.offSetup(new Chance(seed), sensor);
      assertWithin(0.033, 0.057, off.edgeWidthM());
      assertWithin(0.01, 0.014, off.missRate());
      assertWithin(0.0036, 0.006, off.rangeNoiseM());
      assertWithin(0.01, 0.08, off.tailShare());
      assertWithin(2.5, 5, off.tailScale());
      assertWithin(0, 0.35, off.persistence());
      assertWithin(0.006, 0.022, off.ripple().share());
      assertWithin(1, 4, off.ripple().waves());
      assertWithin(Math.toRadians(0.2), Math.toRadians(1.2), off.beamEdgeRad());
      assertWithin(Math.toRadians(-0.15), Math.toRadians(0.15), off.wideningRad());
    }
  }

  @Test
  void rounding_isToSteps() {
    assertEquals(1.25, Shapes.rounded(1.26, 0.05), 1e-12);
    assertEquals(1.3, Shapes.rounded(1.28, 0.05), 1e-12);
    assertEquals(-0.12, Shapes.rounded(-0.118, 0.01), 1e-12);
    assertEquals(List.of("run", "bench"), Design.kinds());
  }
}
