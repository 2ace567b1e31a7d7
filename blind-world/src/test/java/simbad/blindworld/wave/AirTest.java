package simbad.blindworld.wave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The air against the standard's own tables and against the same formula worked elsewhere. */
class AirTest {

  /**
   * ISO 9613-2:1996, table 2, decibels per kilometre to the digits it prints, at the exact
   * frequencies of the bands 1, 2, 4 and 8 kHz (powers of 10).
   */
  @ParameterizedTest
  @CsvSource({
    "10, 70, 1000, 3.7, 0.05",
    "10, 70, 3981.07, 32.8, 0.1",
    "10, 70, 7943.28, 117, 0.5",
    "20, 70, 1000, 5.0, 0.05",
    "20, 70, 7943.28, 76.6, 0.1",
    "15, 20, 1995.26, 28.2, 0.1",
    "15, 80, 7943.28, 82.8, 0.1",
  })
  void absorption_isTheStandards(
      double celsius, double percent, double frequencyHz, double dbPerKm, double tolerance) {
    Air air = new Air(celsius, percent, 101.325);
    assertEquals(dbPerKm, 1000 * air.absorptionDbPerM(frequencyHz), tolerance);
  }

  /** At 40 kHz, by the same formula in another program, to the digits that were kept. */
  @ParameterizedTest
  @CsvSource({"0, 50, 0.45", "20, 10, 0.46", "20, 50, 1.32", "20, 100, 1.11", "40, 20, 1.73"})
  void absorptionAt40Khz_isWhatOthersCompute(double celsius, double percent, double dbPerM) {
    assertEquals(dbPerM, new Air(celsius, percent, 101.325).absorptionDbPerM(40_000), 0.006);
  }

  @ParameterizedTest
  @CsvSource({"-10, 325.2", "0, 331.3", "20, 343.2", "40, 354.7"})
  void soundSpeed_goesWithTheRootOfTemperature(double celsius, double metresPerSecond) {
    assertEquals(metresPerSecond, new Air(celsius, 50, 101.325).soundSpeedMPerS(), 0.1);
  }

  @Test
  void whatNoAirIs_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Air(-300, 50, 101));
    assertThrows(IllegalArgumentException.class, () -> new Air(20, 101, 101));
    assertThrows(IllegalArgumentException.class, () -> new Air(20, Double.NaN, 101));
    assertThrows(IllegalArgumentException.class, () -> new Air(20, 50, 0));
  }
}
