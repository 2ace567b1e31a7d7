package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

class UncertaintyTest {
  private static final double OFFSET_M = 0.04;
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", OFFSET_M);

  private static CalibratedLog given(Hypothesis truth, int rows, long seed) {
    return Worlds.given(Worlds.read(Worlds.poses(rows, 0.3, 2, seed), truth, seed + 1000));
  }

  private static Hypothesis and(Hypothesis some, Effect effect, String form, double... values) {
    Form of = Forms.find(effect, form, Worlds.POST, List.of("s")).orElseThrow();
    return some.and(of, values);
  }

  /** 1.96 deviations hold the true value in 95 of 100 logs; fewer than 33 of 40 once in 10,000. */
  @Test
  void deviations_areThoseBetweenLogs() {
    Hypothesis truth = and(OFFSET, Effect.DROPOUT, "single", 0.1);
    int[] held = new int[2];
    for (int seed = 0; seed < 40; seed++) {
      CalibratedLog given = given(truth, 300, seed);
      Hypothesis fit = new Fitter(given, Fold.ALL).refine(truth, 0).hypothesis();
      double[] deviations = new Uncertainty(given, 1).deviations(fit);
      for (int i = 0; i < held.length; i++) {
        double away = Math.abs(fit.values()[i] - truth.values()[i]);
        held[i] += away < 1.96 * deviations[i] ? 1 : 0;
        assertTrue(deviations[i] < 0.1, "deviation " + deviations[i]);
      }
    }
    assertTrue(held[0] >= 33 && held[1] >= 33, Arrays.toString(held));
  }

  /** Pings that hang together by a factor of four tell as much as a quarter of them. */
  @Test
  void clumping_widens() {
    CalibratedLog given = given(OFFSET, 300, 1);
    double alone = new Uncertainty(given, 1).deviations(OFFSET)[0];
    assertEquals(2 * alone, new Uncertainty(given, 4).deviations(OFFSET)[0], 1e-12);
  }

  @Test
  void table_isHeldWhileOthersVary() {
    double[] table = new double[Forms.TABLE_SIZE];
    Arrays.fill(table, 1.2);
    Hypothesis both = and(OFFSET, Effect.ORIENTATION_SHADOW, "table:post#0", table);
    double[] deviations = new Uncertainty(given(both, 600, 2), 1).deviations(both);
    assertTrue(deviations[0] < 0.002, "deviation " + deviations[0]);
    assertTrue(Arrays.stream(deviations).skip(1).allMatch(Double::isInfinite));
  }

  /** From where chance echoes would come means nothing where there are none. */
  @Test
  void valuesThatMeanNothing_areUnboundedAndLeaveTheOthersBounded() {
    Hypothesis none = and(OFFSET, Effect.CROSSTALK, "any", 0, 0.5, 2);
    double[] deviations = new Uncertainty(given(OFFSET, 600, 3), 1).deviations(none);
    assertTrue(deviations[0] < 0.002, "deviation " + deviations[0]);
    assertTrue(Double.isInfinite(deviations[2]) && Double.isInfinite(deviations[3]));
  }

  /** Readings that scatter by 5 mm tell a shift to 5 mm over the root of their number. */
  @Test
  void deviation_isThatOfAMean() {
    SensingSetup fine =
        new SensingSetup(
            Worlds.POST.sensor().withResolution(0), Worlds.POST.scene(), Worlds.POST.noEchoM());
    for (int rows : new int[] {100, 400}) {
      List<ReadingRow> read = Worlds.read(fine, Worlds.poses(rows, 0.3, 0.9, 4), OFFSET, 5);
      CalibratedLog given = new CalibratedLog(fine, List.of(), new PingLog(read));
      double expected = 0.005 / Math.sqrt(given.log().echoes());
      assertEquals(expected, new Uncertainty(given, 1).deviations(OFFSET)[0], 0.03 * expected);
    }
  }

  /** Beside a scale a shift is known less well than alone. */
  @Test
  void valuesThatHangTogether_areKnownLessWell() {
    CalibratedLog given = given(OFFSET, 400, 6);
    double alone = new Uncertainty(given, 1).deviations(OFFSET)[0];
    Hypothesis both = and(OFFSET, Effect.SOUND_SPEED, "scale", 343);
    double[] deviations = new Uncertainty(given, 1).deviations(both);
    // Distances between 0.3 and 1.5 m: their mean over their spread is 0.9 / 0.35, so that the
    // shift is known worse by the root of 1 + 2.6 squared, about 2.8.
    assertEquals(2.8, deviations[0] / alone, 0.5);
    // A scale is known to the scatter over the root of the number and the spread.
    assertEquals(alone / 0.35 * 343, deviations[1], 0.2 * alone / 0.35 * 343);
  }

  @Test
  void nothing_hasNoDeviations() {
    assertEquals(0, new Uncertainty(given(OFFSET, 50, 7), 1).deviations(Hypothesis.NONE).length);
  }
}
