package simbad.sonar.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Refusal;

class SonarSpecTest {
  private static final List<String> FIELDS =
      List.of(
          "coneHalfAngleRad",
          "minRangeM",
          "maxRangeM",
          "mountHeightM",
          "assumedSoundSpeedMPerS",
          "resolutionM",
          "rangeNoiseM",
          "missRate",
          "edgeWidthM",
          "updatePeriodS");

  /** A good sensor but for one field. */
  private static SonarSpec with(String field, double value) {
    double[] f = {0.48, 0.03, 6, 0.05, 343, 0.01, 0.005, 0.02, 0.1, 0.05};
    f[FIELDS.indexOf(field)] = value;
    return new SonarSpec("s", f[0], f[1], f[2], f[3], f[4], f[5], f[6], f[7], f[8], f[9]);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "coneHalfAngleRad | 0 | (0, pi]",
        "coneHalfAngleRad | 3.1416 | (0, pi]",
        "minRangeM | -0.01 | [0, infinity)",
        "maxRangeM | 0.03 | (minRangeM = 0.03, infinity)",
        "maxRangeM | -1 | (minRangeM = 0.03, infinity)",
        "mountHeightM | -0.05 | [0, infinity)",
        "assumedSoundSpeedMPerS | 0 | (0, infinity)",
        "resolutionM | -0.01 | [0, infinity)",
        "rangeNoiseM | -1e-9 | [0, infinity)",
        "missRate | -0.1 | [0, 1]",
        "missRate | 1.0001 | [0, 1]",
        "edgeWidthM | -0.1 | [0, infinity)",
        "updatePeriodS | 0 | (0, infinity)"
      })
  void figure_outOfItsDomain_isRefused(String field, double bad, String permitted) {
    Refusal.check(() -> with(field, bad), field + " = " + bad, "is not in " + permitted);
  }

  @Test
  void figure_notFinite_isRefused() {
    for (String field : FIELDS) {
      for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
        Refusal.check(() -> with(field, bad), field + " = " + bad, "is not in");
      }
    }
  }

  @Test
  void figure_atTheEndOfItsDomain_isTaken() {
    assertEquals(Math.PI, with("coneHalfAngleRad", Math.PI).coneHalfAngleRad());
    assertEquals(0, with("minRangeM", 0).minRangeM());
    assertEquals(0, with("mountHeightM", 0).mountHeightM());
    assertEquals(0, with("resolutionM", 0).resolutionM());
    assertEquals(0, with("rangeNoiseM", 0).rangeNoiseM());
    assertEquals(0, with("missRate", 0).missRate());
    assertEquals(1, with("missRate", 1).missRate());
    assertEquals(0, with("edgeWidthM", 0).edgeWidthM());
  }
}
