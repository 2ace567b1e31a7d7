package simbad.gap.audit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.fixture.Logs;
import simbad.sonar.scene.SonarSpec;

/** What the checks are made of: words, numbers, chances, lines, codes and limits. */
class AuditPartsTest {
  /** Of 15 degrees, 4 m, in whole centimetres or finer. */
  private static final SonarSpec SENSOR = Logs.BOARD.sensor();

  private static SonarSpec sensor(double maxRangeM, double soundMPerS, double coneHalfAngleRad) {
    return new SonarSpec(
        SENSOR.name(),
        coneHalfAngleRad,
        SENSOR.minRangeM(),
        maxRangeM,
        SENSOR.mountHeightM(),
        soundMPerS,
        SENSOR.resolutionM(),
        SENSOR.rangeNoiseM(),
        SENSOR.missRate(),
        SENSOR.edgeWidthM(),
        SENSOR.updatePeriodS());
  }

  @ParameterizedTest
  @CsvSource({
    "0, 0",
    "1e-30, 1E-30",
    "1e-6, 0.000001",
    "9.9e-7, 9.9E-7",
    "-0.25, -0.25",
    "1234.56, 1235",
    "-1e11, -100000000000",
    "1e12, 1E+12"
  })
  void numbersHaveAnExponentOnlyWhereTheyNeedOne(double value, String said) {
    assertEquals(said, Say.number(value));
  }

  @Test
  void exactNumbersAreFoundAgainInAFile() {
    assertEquals("11.4999999999", Say.exact(11.4999999999));
    assertEquals("0.1", Say.exact(0.1));
  }

  @Test
  void oneIsNoPlural() {
    assertEquals("1 reading", Say.readings(1));
    assertEquals("2 readings", Say.readings(2));
    assertEquals("1 row", Say.rows(1));
    assertEquals("0 rows", Say.rows(0));
  }

  @Test
  void wordsAreThoseOfTheFormat() {
    assertEquals(
        List.of("note", "warn", "refuse"),
        Arrays.stream(Severity.values()).map(Severity::word).toList());
    assertEquals(
        List.of("scene.json", "readings.csv", "reference.csv", "commands.csv", "track.csv"),
        Arrays.stream(File.values()).map(File::fileName).toList());
  }

  /** The false alarms that all together may have are shared among so many. */
  @Test
  void sixteenChecksAreOfReadings() {
    assertEquals(16, AuditCheck.ofReadings());
  }

  /** By adding the binomial's terms. */
  @ParameterizedTest
  @CsvSource({"1, 1, 0.3", "2, 5, 0.1", "7, 9, 0.6", "40, 120, 0.25", "120, 120, 0.99"})
  void theTailIsTheSumOfItsTerms(int hits, int trials, double chance) {
    double term = Math.pow(1 - chance, trials);
    double below = 0;
    for (int k = 0; k < hits; k++) {
      below += term;
      term *= (trials - k) / (k + 1.0) * chance / (1 - chance);
    }
    assertEquals(1 - below, Tail.atLeast(hits, trials, chance), 1e-9);
  }

  @Test
  void theTailOfWhatIsSureIsSure() {
    assertEquals(1, Tail.atLeast(0, 5, 0.5));
    assertEquals(0, Tail.atLeast(1, 5, 0));
    assertEquals(1, Tail.atLeast(5, 5, 1));
  }

  /** 38 ms there and back at 343 m/s are 6.517 m. */
  @ParameterizedTest
  @CsvSource({
    "0, 4, nought",
    "4, 4, the most that the sensor reads",
    "3.6, 3.6, the most that the sensor reads",
    "3.59, 3.59, ''",
    "3.6, 3.7, ''",
    "3.9995, 9, the most that the sensor reads",
    "4.0005, 9, the most that the sensor reads",
    "6.517, 9, '38 ms of flight, the sensor''s time-out'",
    "6.6, 9, '38 ms of flight, the sensor''s time-out'",
    "6.61, 9, ''",
    "7.65, 9, a counter's end",
    "7.651, 9, ''",
    "2.55, 9, a counter's end",
    "65.535, 99, a counter's end",
    "1.234, 9, ''"
  })
  void codesAreKnown(double value, double greatest, String meaning) {
    assertEquals(
        meaning.isEmpty() ? Optional.empty() : Optional.of(meaning),
        Code.meaning(value, SENSOR, greatest));
  }

  @ParameterizedTest
  @CsvSource({
    "306, ''",
    "305.9, warn",
    "366, ''",
    "366.1, warn",
    "68.6, warn",
    "68.5, refuse",
    "1715, warn",
    "1716, refuse"
  })
  void soundHasASpeed(double speed, String severity) {
    List<String> found =
        ConstantCheck.of(sensor(4, speed, 0.2)).stream().map(one -> one.severity().word()).toList();
    assertEquals(severity.isEmpty() ? List.of() : List.of(severity), found);
  }

  @Test
  void aSonarHearsNoFurtherThanSoundInAir() {
    assertEquals(List.of(), ConstantCheck.of(sensor(100, 343, 0.2)));
    assertTrue(ConstantCheck.of(sensor(100.1, 343, 0.2)).get(0).what().contains("max_range_m"));
  }

  @Test
  void aConeIsWiderThanHalfADegree() {
    assertEquals(List.of(), ConstantCheck.of(sensor(4, 343, Math.toRadians(0.5001))));
    assertTrue(
        ConstantCheck.of(sensor(4, 343, Math.toRadians(0.49))).get(0).what().contains("cone"));
  }

  /** A fifth to five times, and what the air's temperature does. */
  @Test
  void aConstantIsWrongByFiveTimesAtMost() {
    double most = 5 * (1 + AuditView.AIR);
    assertFalse(Factor.isBeyondSound(most));
    assertFalse(Factor.isBeyondSound(1));
    assertTrue(Factor.isBeyondSound(most + 1e-9));
    assertTrue(Factor.isBeyondSound(1 / most - 1e-9));
    assertEquals("inches written as metres", Factor.of(39.37).orElseThrow().words());
    assertEquals(0.5, Factor.of(2).orElseThrow().undo());
    assertEquals(Optional.empty(), Factor.of(1.5));
  }

  /** Least squares of what is on the line; what is off it has no weight. */
  @Test
  void aLineGoesThroughMostPoints() {
    double[] x = DoubleStream.iterate(0.2, d -> d < 2, d -> d + 0.05).toArray();
    double[] y = new double[x.length];
    Arrays.setAll(y, i -> 0.985 * x[i] - 0.009 + (i % 2 == 0 ? 1e-3 : -1e-3));
    y[7] = 3;
    y[20] = 0;
    RobustLine line = RobustLine.through(x, y, 0.001, 0.01);

    assertEquals(0.985, line.slope(), 1e-3);
    assertEquals(-0.009, line.offset(), 1e-3);
    assertEquals((x.length - 2.0) / x.length, line.share(), 1e-12);
  }
}
