package simbad.sonar.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.StrengthTable;

class StrengthDetectionTest {
  private static final LevelLaw LAW = Sonars.exact(27.5, 0.03, 6).levelLaw();

  /** For those who know thresholds only: the strength of a threshold has that threshold. */
  @ParameterizedTest
  @CsvSource({"0.05", "0.3", "1", "2.5", "4"})
  void thresholds_ofAStrength_comeBack(double thresholdM) {
    StrengthTable strength = StrengthTable.of(LAW.strengthDb(thresholdM));
    StrengthDetection detection = StrengthDetection.of(strength, LAW, 6);
    assertEquals(thresholdM, detection.thresholdM(0), 1e-9);
    assertEquals(thresholdM, detection.greatestM(), 1e-9);
    assertEquals(Optional.of(detection.thresholds()), detection.findTable());
  }

  /** 10 bearings become 80: the strength is straight in decibels between its own. */
  @ParameterizedTest
  @CsvSource({"1, 72", "10, 80", "71, 142", "72, 72", "100, 100"})
  void thresholds_areAtTheStrengthsBearings(int strengths, int thresholds) {
    StrengthDetection detection =
        StrengthDetection.of(StrengthTable.of(new double[strengths]), LAW, 6);
    assertEquals(thresholds, detection.thresholds().size());
  }

  @Test
  void thresholds_endAtTheSensorsRange() {
    assertEquals(6, StrengthDetection.of(StrengthTable.of(200), LAW, 6).greatestM());
    assertEquals(0, StrengthDetection.of(StrengthTable.of(-200), LAW, 6).greatestM());
    assertTrue(StrengthDetection.of(StrengthTable.of(200), LAW, 1e6).greatestM() <= 100);
  }
}
