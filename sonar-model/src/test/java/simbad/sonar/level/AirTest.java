package simbad.sonar.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.aggregator.ArgumentsAccessor;
import org.junit.jupiter.params.provider.CsvSource;

class AirTest {
  /** 40 kHz, 101.325 kPa, computed from the standard's formula by another program: dB per metre. */
  @ParameterizedTest
  @CsvSource({
    "0, 10, 0.26",
    "0, 100, 0.73",
    "10, 50, 0.85",
    "20, 10, 0.46",
    "20, 30, 1.07",
    "20, 50, 1.32",
    "20, 80, 1.23",
    "30, 30, 1.53",
    "30, 90, 0.95",
    "40, 20, 1.73",
    "40, 100, 0.72"
  })
  void absorption_at40kHz(double temperatureC, double humidityPercent, double dbPerM) {
    assertEquals(dbPerM, new Air(temperatureC, humidityPercent).absorptionDbPerM(40_000), 0.0051);
  }

  /** ISO 9613-1:1993, table 1: 1 kHz, 20 degrees, 50 %: 4.66 dB per km; 10 kHz: 159 dB per km. */
  @ParameterizedTest
  @CsvSource({"1000, 4.66", "10000, 159"})
  void absorption_isTheStandardsTable(double frequencyHz, double dbPerKm) {
    assertEquals(dbPerKm, 1000 * Air.ROOM.absorptionDbPerM(frequencyHz), 0.01 * dbPerKm);
  }

  @ParameterizedTest
  @CsvSource({"-40", "-5.5", "0", "20", "60"})
  void nearest_toTheSpeedOfAir_isThatAir(double temperatureC) {
    Air air = Air.nearest(new Air(temperatureC, 35).soundSpeedMPerS(), 35);
    assertEquals(temperatureC, air.temperatureC(), 1e-9);
    assertEquals(35, air.humidityPercent());
  }

  @Test
  void nearest_whereNoAirIsSoSlowOrFast_isTheColdestOrTheWarmest() {
    assertEquals(new Air(-40, 50), Air.nearest(200, 50));
    assertEquals(new Air(60, 50), Air.nearest(500, 50));
    assertThrows(IllegalArgumentException.class, () -> Air.nearest(Double.NaN, 50));
  }

  /** Found by looking at each degree and each percent. */
  @Test
  void mostAndLeast_areThoseOfAllAir() {
    for (double hz : new double[] {25_000, 40_000, 60_000}) {
      double most = 0;
      double least = Double.POSITIVE_INFINITY;
      for (int celsius = -40; celsius <= 60; celsius++) {
        for (int percent = 0; percent <= 100; percent++) {
          double here = new Air(celsius, percent).absorptionDbPerM(hz);
          most = Math.max(most, here);
          least = Math.min(least, here);
        }
      }
      assertEquals(most, Air.mostDbPerM(hz), 1e-12);
      assertEquals(least, Air.leastDbPerM(hz), 1e-12);
    }
    assertEquals(2.2, Air.mostDbPerM(40_000), 0.05);
    assertEquals(0.23, Air.leastDbPerM(40_000), 0.005);
  }

  /**
   * ISO 9613-2:1996, table 2, which its authors computed by part 1: dB per km at the exact middles
   * of eight octaves, to the digits that it gives.
   */
  @ParameterizedTest
  @CsvSource({
    "10, 70, 0.1, 0.4, 1.0, 1.9, 3.7, 9.7, 32.8, 117",
    "20, 70, 0.1, 0.3, 1.1, 2.8, 5.0, 9.0, 22.9, 76.6",
    "30, 70, 0.1, 0.3, 1.0, 3.1, 7.4, 12.7, 23.1, 59.3",
    "15, 20, 0.3, 0.6, 1.2, 2.7, 8.2, 28.2, 88.8, 202",
    "15, 50, 0.1, 0.5, 1.2, 2.2, 4.2, 10.8, 36.2, 129",
    "15, 80, 0.1, 0.3, 1.1, 2.4, 4.1, 8.3, 23.7, 82.8"
  })
  void absorption_isPublishedOfEightOctaves(ArgumentsAccessor row) {
    Air air = new Air(row.getDouble(0), row.getDouble(1));
    for (int octave = 0; octave < 8; octave++) {
      double published = row.getDouble(2 + octave);
      double frequencyHz = 1000 * Math.pow(10, 0.3 * (octave - 4));
      double dbPerKm = 1000 * air.absorptionDbPerM(frequencyHz);
      assertEquals(published, dbPerKm, published >= 100 ? 0.5 : 0.052, row + ", octave " + octave);
    }
  }

  @ParameterizedTest
  @CsvSource({"-10, 325.2", "0, 331.3", "20, 343.2", "40, 354.7"})
  void soundSpeed_followsTheTemperature(double temperatureC, double speed) {
    assertEquals(speed, new Air(temperatureC, 50).soundSpeedMPerS(), 0.05);
  }

  @Test
  void impossibleAir_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Air(-41, 50));
    assertThrows(IllegalArgumentException.class, () -> new Air(20, 101));
    assertThrows(IllegalArgumentException.class, () -> new Air(Double.NaN, 50));
  }
}
