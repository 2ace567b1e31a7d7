package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

/** The gap of single pings half a metre before a post, whose face is then 0.45 m away. */
class GapMeterTest {
  private static final double FACE_M = 0.45;

  private static CalibratedLog given(double noiseM, double missRate, Reading... readings) {
    SonarSpec sensor =
        new SonarSpec("s", Math.toRadians(20), 0.02, 4, 0.1, 343, 0, noiseM, missRate, 0.001, 0.05);
    List<ReadingRow> rows = new ArrayList<>();
    for (Reading reading : readings) {
      // The last one looks away.
      double heading = rows.size() == readings.length - 1 ? -Math.PI / 2 : Math.PI / 2;
      rows.add(new ReadingRow("r", "s", 0.1 * rows.size(), Pose.of(0, 0.5, heading), reading));
    }
    SensingSetup setup = new SensingSetup(sensor, Worlds.POST.scene(), 4);
    return new CalibratedLog(setup, List.of(), new PingLog(rows));
  }

  private static GapMeter.Gaps measured(CalibratedLog given, Hypothesis hypothesis) {
    return new GapMeter(given).measure(given, hypothesis);
  }

  /**
   * Of 19 quantiles those of 0.05 to 0.65 lie at the face and six at no-echo, 3.55 m beyond. An
   * echo costs twice the mean of 0.30 + 0.25 + ... + 0.05 = 1.05 times that, a miss that of 0.05 +
   * ... + 0.65 = 4.55.
   */
  @Test
  void gap_isThatOfTheQuantiles_andItsExpectationThatOfBothReadings() {
    CalibratedLog given =
        given(1e-7, 0.32, new Echo(FACE_M), NoEcho.NO_ECHO, new Echo(FACE_M - 0.1), NoEcho.NO_ECHO);
    GapMeter.Gaps gaps = measured(given, Hypothesis.NONE);
    double echo = 2 * 1.05 * 3.55 / 19;
    double miss = 2 * 4.55 * 3.55 / 19;
    assertEquals(echo, gaps.observedM()[0], 1e-5);
    assertEquals(miss, gaps.observedM()[1], 1e-5);
    // 10 cm short of all quantiles: each costs as much more as it is above, of mean 1/2.
    assertEquals(echo + 0.1, gaps.observedM()[2], 1e-5);
    assertEquals(0, gaps.observedM()[3], 1e-5, "nothing there, nothing heard");
    for (int i = 0; i < 3; i++) {
      assertEquals(0.68 * echo + 0.32 * miss, gaps.expectedM()[i], 1e-5);
    }
    assertEquals(0, gaps.expectedM()[3], 1e-5);
  }

  /** The score of a normal distribution is on average its deviation over root pi. */
  @Test
  void expectation_ofNormalScatter_isItsScore() {
    double sigma = 0.02;
    GapMeter.Gaps gaps =
        measured(given(sigma, 0, new Echo(FACE_M), NoEcho.NO_ECHO), Hypothesis.NONE);
    assertEquals(sigma / Math.sqrt(Math.PI), gaps.expectedM()[0], 0.04 * sigma);
    // At the middle it is sigma (root 2 - 1) / root pi.
    assertEquals(
        sigma * (Math.sqrt(2) - 1) / Math.sqrt(Math.PI), gaps.observedM()[0], 0.03 * sigma);
  }

  /** An offset of 10 cm that is modelled leaves no gap, one that is not leaves all of it. */
  @Test
  void hypothesis_movesTheForecast() {
    CalibratedLog given = given(1e-7, 0, new Echo(FACE_M + 0.1), NoEcho.NO_ECHO);
    Hypothesis offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.1);
    assertEquals(0.1, measured(given, Hypothesis.NONE).observedM()[0], 1e-5);
    assertEquals(0, measured(given, offset).observedM()[0], 1e-5);
  }

  @Test
  void gaps_areNumbers() {
    assertThrows(
        IllegalArgumentException.class,
        () -> new GapMeter.Gaps(new double[] {Double.NaN}, new double[1]));
    assertThrows(
        IllegalArgumentException.class,
        () -> new GapMeter.Gaps(new double[1], new double[] {Double.NaN}));
  }
}
