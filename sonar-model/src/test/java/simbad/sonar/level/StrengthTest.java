package simbad.sonar.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.shape.ThresholdTable;

class StrengthTest {
  private static final LevelLaw LAW = LevelFigures.NONE.law(0.48, 0.004);

  /** Four bearings: -10 ahead (0), -20 at 90, -14 at 180, -30 at 270 degrees. */
  @ParameterizedTest
  @CsvSource({"0, -10", "45, -15", "90, -20", "135, -17", "270, -30", "315, -20", "359.1, -10.2"})
  void table_isStraightInDecibels(double bearingDeg, double expectedDb) {
    StrengthTable table = StrengthTable.of(-10, -20, -14, -30);
    assertEquals(expectedDb, table.strengthDb(Math.toRadians(bearingDeg)), 1e-9);
  }

  @Test
  void table_ofOneValue_isUniform() {
    StrengthTable table = StrengthTable.of(-7);
    assertEquals(-7, table.strengthDb(0));
    assertEquals(-7, table.strengthDb(6));
    assertEquals(-7, table.greatestDb());
  }

  @Test
  void table_isAValue() {
    StrengthTable table = StrengthTable.of(-10, -20);
    assertEquals(table, StrengthTable.of(-10, -20));
    assertEquals(table.hashCode(), StrengthTable.of(-10, -20).hashCode());
    assertNotEquals(table, StrengthTable.of(-10, -21));
    table.valuesDb()[0] = 5;
    assertEquals(-10, table.greatestDb());
    assertEquals(2, table.size());
    assertEquals("StrengthTable[-10.0, -20.0]", table.toString());
  }

  @Test
  void wrongTable_isRefused() {
    Refusal.check(() -> StrengthTable.of(), "strengthDb is empty");
    Refusal.check(() -> StrengthTable.of(1, 301), "strength = 301.0 is not in [-300, 300] dB");
    Refusal.check(() -> StrengthTable.of(Double.NaN), "strength = NaN");
    Refusal.check(() -> StrengthTable.of(1).strengthDb(7), "bearingRad = 7.0");
  }

  /** At every bearing, between the table's too, the excess on the axis is 0 dB at the threshold. */
  @Test
  void thresholds_areWhereTheExcessIs0() {
    ThresholdTable thresholds = ThresholdTable.of(2.1, 0.3, 1.4, 0.06, 2.9, 1, 1.2);
    TargetStrength strength = TargetStrength.ofThresholds(thresholds, LAW);
    for (double bearing = 0; bearing < 6.28; bearing += 0.01) {
      double db = strength.strengthDb(bearing);
      assertEquals(0, LAW.excessDb(db, 0, thresholds.thresholdM(bearing)), 1e-9);
      assertTrue(db <= strength.greatestDb() + 1e-9, "at " + bearing);
    }
  }

  @Test
  void threshold0_neverAnswers() {
    TargetStrength strength = TargetStrength.ofThresholds(ThresholdTable.of(0, 1, 1), LAW);
    assertEquals(Double.NEGATIVE_INFINITY, strength.strengthDb(0.1));
    assertEquals(Double.NEGATIVE_INFINITY, LAW.excessDb(strength.strengthDb(0.1), 0, 0));
    assertEquals(
        Double.NEGATIVE_INFINITY,
        TargetStrength.ofThresholds(ThresholdTable.uniform(3, 0), LAW).greatestDb());
  }

  @Test
  void uniform_isAlikeAllRound() {
    assertEquals(-3, TargetStrength.uniform(-3).strengthDb(1));
    assertEquals(-3, TargetStrength.uniform(-3).greatestDb());
  }
}
