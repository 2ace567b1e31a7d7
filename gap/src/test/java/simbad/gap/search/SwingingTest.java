package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.sonar.change.RangeSwing;

/**
 * Four hundred pings in forty seconds. Where the log probability rises by a sin(wt) for each metre,
 * the sums over n pings are a n / 2 of the score with the sine, and 3/8 a^2 n of its square: the
 * likeliest swing is 4 / 3a. Five pings to a period make all these sums exact.
 */
class SwingingTest {
  private static final int PINGS = 400;
  private static final double STEP_S = 0.1;
  private static final double DURATION_S = PINGS * STEP_S;
  private static final double PERIOD_S = 0.5;
  private static final double SCORE = 80;

  private static double[] scores(int pings, double stepS, double periodS, double phaseRad) {
    double[] scores = new double[pings];
    Arrays.setAll(scores, i -> SCORE * Math.sin(2 * Math.PI * stepS * i / periodS + phaseRad));
    return scores;
  }

  private static Optional<Swinging.Found> likeliest(
      double[] scores, double stepS, double durationS) {
    return new Swinging(scores, i -> stepS * i, durationS).likeliest();
  }

  @Test
  void swing_isFoundWithItsPeriodAndPhase() {
    for (double phase : new double[] {0, 0.4, Math.PI / 2, 3}) {
      RangeSwing swing =
          likeliest(scores(PINGS, STEP_S, PERIOD_S, phase), STEP_S, DURATION_S)
              .orElseThrow()
              .swing();
      assertEquals(PERIOD_S, swing.periodS(), 1e-12);
      assertEquals(4 / (3 * SCORE) * Math.cos(phase), swing.sineM(), 1e-9);
      assertEquals(4 / (3 * SCORE) * Math.sin(phase), swing.cosineM(), 1e-9);
    }
  }

  /** A reading whose probability rises twice as fast with its range lies half as far away. */
  @Test
  void steeperScores_areOfASmallerSwing() {
    double[] twice = scores(PINGS, STEP_S, PERIOD_S, 1);
    double gentle = likeliest(twice, STEP_S, DURATION_S).orElseThrow().swing().amplitudeM();
    Arrays.setAll(twice, i -> 2 * twice[i]);
    assertEquals(
        gentle / 2, likeliest(twice, STEP_S, DURATION_S).orElseThrow().swing().amplitudeM(), 1e-9);
  }

  /** Between 50 swings, which are no drift, and one in four pings: 100. */
  @Test
  void choice_isOfAsManyPeriodsAsDiffer() {
    double[] scores = scores(PINGS, STEP_S, PERIOD_S, 0);
    assertEquals(
        Math.log(50), likeliest(scores, STEP_S, DURATION_S).orElseThrow().choiceNats(), 1e-9);
    // With many pings the shortest period ends it: 40 s have 400 / 3 of 0.3 s.
    double[] many = scores(4 * PINGS, STEP_S / 4, PERIOD_S, 0);
    Swinging.Found found = likeliest(many, STEP_S / 4, DURATION_S).orElseThrow();
    assertEquals(PERIOD_S, found.swing().periodS(), 1e-12);
    assertEquals(Math.log(400 / 3.0 - 50), found.choiceNats(), 1e-9);
  }

  /** 202 pings leave room for half a swing more than 50: one period costs no choice. */
  @Test
  void choiceOfOne_costsNothing() {
    double[] scores = scores(202, STEP_S, 0.404, 0);
    Swinging.Found found = likeliest(scores, STEP_S, 202 * STEP_S).orElseThrow();
    assertEquals(0, found.choiceNats());
    assertEquals(0.404, found.swing().periodS(), 0.003);
  }

  @Test
  void shortLog_hasNone() {
    double[] scores = scores(200, STEP_S, PERIOD_S, 0);
    assertTrue(likeliest(scores, STEP_S, 200 * STEP_S).isEmpty(), "50 swings of four pings");
    double[] dense = scores(PINGS, 0.03, PERIOD_S, 0);
    assertTrue(likeliest(dense, 0.03, 15).isEmpty(), "50 swings of 0.3 s");
    assertTrue(likeliest(dense, 0.03, 0).isEmpty(), "nothing can be said of time");
  }

  @Test
  void whereNothingIsLeftOver_nothingSwings() {
    assertTrue(likeliest(new double[PINGS], STEP_S, DURATION_S).isEmpty());
    double[] one = new double[PINGS];
    one[17] = SCORE;
    assertTrue(likeliest(one, STEP_S, DURATION_S).isEmpty(), "one reading has no period");
    double[] same = scores(PINGS, STEP_S, PERIOD_S, 1);
    assertTrue(new Swinging(same, i -> 0, DURATION_S).likeliest().isEmpty(), "all at one time");
  }
}
