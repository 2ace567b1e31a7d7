package simbad.sonar.shape;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import net.jqwik.api.ForAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Reference;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Seeded;
import simbad.sonar.fixture.Shapes;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;

class ThresholdTableTest {
  private static final int[] SIZES = {3, 36, 72, 360};

  @Seeded
  void threshold_isTheRadiusOfThePolygon(@ForAll Random random) {
    double bearing = random.nextDouble(0, Angles.TURN_RAD);
    for (int size : SIZES) {
      ThresholdTable table = Shapes.anyTable(random, size, false);
      double reference = Reference.polygonRadiusM(table.valuesM(), bearing);
      assertEquals(reference, table.thresholdM(bearing), 1e-9, "size " + size);
    }
  }

  /** Four equal values make a square on its corner; its side is at 1 / sqrt 2 halfway. */
  @ParameterizedTest
  @CsvSource({
    "0, 1",
    "45, 0.70710678118655",
    "90, 1",
    "180, 1",
    "270, 1",
    "315, 0.70710678118655",
    "30, 0.73205080756888",
    "359.9999999, 1"
  })
  void threshold_ofASquare(double bearingDeg, double expected) {
    // Halfway to the side is 1 / (cos b + sin b): at 30 degrees 2 / (1 + sqrt 3).
    ThresholdTable table = ThresholdTable.uniform(4, 1);
    assertEquals(expected, table.thresholdM(Math.toRadians(bearingDeg)), 2e-9);
  }

  /** Every way to write a table's bearing gives its value, beside a 0 as well. */
  @ParameterizedTest
  @ValueSource(ints = {3, 7, 36, 72, 360})
  void threshold_atTheTablesBearings_isTheValue(int size) {
    ThresholdTable table = Shapes.anyTable(new Random(size), size, true);
    for (int i = 0; i < size; i++) {
      String at = "value " + i + " of " + size;
      double fromDegrees = Math.toRadians(i * 360.0 / size);
      double fromPlace = Angles.positive(Math.atan2(Math.sin(fromDegrees), Math.cos(fromDegrees)));
      assertEquals(table.valueM(i), table.thresholdM(table.bearingRad(i)), 1e-12, at);
      assertEquals(table.valueM(i), table.thresholdM(fromDegrees), 1e-12, at);
      assertEquals(table.valueM(i), table.thresholdM(fromPlace), 1e-12, at);
    }
  }

  /**
   * From a value down to a 0 next to it the edge runs to the centre: a ray between meets it at 0.
   */
  @Test
  void threshold_besideAZero_is0() {
    ThresholdTable table = ThresholdTable.of(2, 0, 3, 1, 0, 0);
    for (double bearingDeg : new double[] {1, 30, 59, 61, 90, 119, 181, 239, 241, 270, 299, 359}) {
      assertEquals(0, table.thresholdM(Math.toRadians(bearingDeg)), "at " + bearingDeg);
    }
    assertEquals(2, table.thresholdM(0));
    assertTrue(table.thresholdM(Math.toRadians(150)) > 0);
  }

  @Seeded
  void threshold_isNeverAboveTheGreatest(@ForAll Random random) {
    double bearing = random.nextDouble(0, Angles.TURN_RAD);
    ThresholdTable table = Shapes.anyTable(random, random.nextInt(3, 100), true);
    double threshold = table.thresholdM(bearing);
    assertTrue(threshold >= 0 && threshold <= table.greatestM() + 1e-12, "" + threshold);
  }

  @ParameterizedTest
  @ValueSource(doubles = {-0.001, -7, 6.2832, 1e6, Double.NaN, Double.POSITIVE_INFINITY})
  void threshold_atABearingOutOfItsInterval_isRefused(double bad) {
    ThresholdTable table = ThresholdTable.uniform(72, 1);
    Refusal.check(() -> table.thresholdM(bad), "bearingRad = " + bad, "[0, 2 pi)");
  }

  @Test
  void points_standAtTSinTCos() {
    ThresholdTable table = ThresholdTable.of(1, 2, 3, 4);
    // Bearings 0, 90, 180, 270 are +z, +x, -z, -x.
    double[][] expected = {{0, 1}, {2, 0}, {0, -3}, {-4, 0}};
    for (int i = 0; i < 4; i++) {
      Point point = new Point(expected[i][0], expected[i][1]);
      assertEquals(0, point.distanceM(table.points().get(i)), 1e-15, "point " + i);
    }
  }

  @Test
  void values_areCopiedInAndOut() {
    double[] values = {1, 2, 3};
    ThresholdTable table = ThresholdTable.of(values);
    values[0] = 9;
    table.valuesM()[1] = 9;
    assertArrayEquals(new double[] {1, 2, 3}, table.valuesM());
    assertEquals(3, table.greatestM());
    assertEquals(Math.toRadians(120), table.spacingRad(), 1e-15);
  }

  @Test
  void equality_isByValues() {
    ThresholdTable table = ThresholdTable.of(1, 1, 1);
    assertEquals(table, ThresholdTable.uniform(3, 1));
    assertEquals(table.hashCode(), ThresholdTable.uniform(3, 1).hashCode());
    assertNotEquals(table, ThresholdTable.uniform(4, 1));
    assertNotEquals(table, (Object) "table");
    assertTrue(table.toString().contains("1.0, 1.0, 1.0"), table.toString());
  }

  @Test
  void values_outOfTheirDomain_areRefused() {
    Refusal.check(() -> ThresholdTable.of(), "0 values", "at least 3");
    Refusal.check(() -> ThresholdTable.of(1, 2), "2 values", "at least 3");
    for (double bad : new double[] {-1e-9, 100.001, 1e9, Double.NaN, Double.POSITIVE_INFINITY}) {
      Refusal.check(() -> ThresholdTable.of(1, bad, 1), "threshold = " + bad, "[0, 100.0] m");
    }
    assertEquals(100, ThresholdTable.of(0, 100, 0).greatestM());
  }
}
