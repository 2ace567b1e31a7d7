package simbad.gap.unexplained;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.sensing.ReadingRow;

/** Of 3000 pings; bounds are of five deviations, a false alarm in a million tests. */
class SurpriseTest {
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.02);

  private static Surprise of(Hypothesis truth, Hypothesis hypothesis) {
    List<ReadingRow> rows = Worlds.read(Worlds.poses(3000, 0.3, 2.2, 41), truth, 42);
    CalibratedLog given = Worlds.given(rows);
    return new Surprise(given, hypothesis);
  }

  private static double[] scores(Surprise surprise) {
    return IntStream.range(0, surprise.log.size())
        .filter(surprise.log::echo)
        .mapToDouble(i -> surprise.score[i])
        .toArray();
  }

  private static double mean(double... values) {
    return Arrays.stream(values).average().orElseThrow();
  }

  @Test
  void rightHypothesis_isSurprisedAsOftenAsChance() {
    for (Hypothesis truth : List.of(Hypothesis.NONE, OFFSET)) {
      Surprise surprise = of(truth, truth);
      double[] scores = scores(surprise);
      double n = scores.length;
      assertTrue(n > 1000, n + " echoes");
      assertEquals(0, mean(scores), 5 / Math.sqrt(n));
      assertEquals(
          1,
          mean(Arrays.stream(scores).map(score -> score * score).toArray()),
          5 * Math.sqrt(2 / n));
      double expected = IntStream.range(0, 3000).mapToDouble(i -> surprise.expected[i]).sum();
      assertEquals(expected, n, 5 * Math.sqrt(3000) / 2);
    }
  }

  /** Ranges are 2 cm longer than expected, four deviations of 5 mm; steps of 1 cm blur it. */
  @Test
  void wrongHypothesis_isSurprisedWhereItIsWrong() {
    assertTrue(mean(scores(of(OFFSET, Hypothesis.NONE))) > 2.5);
    assertTrue(mean(scores(of(Hypothesis.NONE, OFFSET))) < -2.5);
  }
}
