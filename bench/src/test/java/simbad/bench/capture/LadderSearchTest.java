package simbad.bench.capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoublePredicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The search and the estimate that follows, before echoes of a known threshold. */
class LadderSearchTest {
  private static final SweepPlan PLAN = SweepPlan.ofBearings(72);

  /** Runs the search to its end. */
  private static List<Level> levels(SweepPlan plan, DoublePredicate echo) {
    LadderSearch search = new LadderSearch(plan);
    List<Level> levels = new ArrayList<>();
    Optional<TriedDistance> probe = search.next(levels);
    while (probe.isPresent()) {
      TriedDistance at = probe.get();
      Level level = new Level(at.distanceM(), at.approach(), 0, 0);
      for (int i = 0; i < plan.pings(); i++) {
        level = level.with(echo.test(at.distanceM()));
      }
      levels.add(level);
      assertTrue(levels.size() < 60, "no end");
      probe = search.next(levels);
    }
    return levels;
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.05, 0.08, 0.36, 1.0, 1.55, 2.88, 3.16, 3.39})
  void sharpEdge_isFoundWithinHalfAStep(double edgeM) {
    ThresholdFit fit = ThresholdFit.of(levels(PLAN, m -> m <= edgeM), PLAN);
    assertTrue(fit.lowM() <= edgeM && edgeM <= fit.highM(), fit.toString());
    assertEquals(edgeM, fit.thresholdM(), 0.0101);
    assertEquals(0.02, fit.highM() - fit.lowM(), 0.0101);
    assertEquals(fit.inM(), fit.outM(), 1e-9);
  }

  @Test
  void nothingHeardOrAllHeard_isSaidAtTheEnds() {
    ThresholdFit never = ThresholdFit.of(levels(PLAN, m -> false), PLAN);
    assertTrue(never.thresholdM() < 0.04 && never.lowM() <= 0.021, never.toString());
    ThresholdFit always = ThresholdFit.of(levels(PLAN, m -> true), PLAN);
    assertTrue(always.thresholdM() > 3.39, always.toString());
  }

  @Test
  void hysteresis_isTheDifferenceOfTheEdges() {
    // Lost at 1.2 m on the way out, found again at 1.1 m.
    boolean[] heard = {true};
    List<Level> levels =
        levels(
            PLAN,
            m -> {
              heard[0] = m <= (heard[0] ? 1.2 : 1.1);
              return heard[0];
            });
    ThresholdFit fit = ThresholdFit.of(levels, PLAN);
    assertEquals(0.1, fit.outM() - fit.inM(), 0.0201);
  }

  /**
   * Soft edges of 2 cm with 0.5 % misses: 95 % intervals hold the truth. Of 200 intervals, with
   * seeds 0 to 199, at least 180: fewer come by chance once in 1000 when 95 % is right.
   */
  @Test
  void softEdge_intervalsHoldTheTruth() {
    int within = 0;
    double sum = 0;
    for (int seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      double edgeM = 0.3 + 2.7 * random.nextDouble();
      ThresholdFit fit =
          ThresholdFit.of(
              levels(PLAN, m -> random.nextDouble() < 0.995 / (1 + Math.exp((m - edgeM) / 0.02))),
              PLAN);
      within += fit.lowM() <= edgeM && edgeM <= fit.highM() ? 1 : 0;
      sum += fit.thresholdM() - edgeM;
    }
    assertTrue(within >= 180, within + " of 200");
    assertEquals(0, sum / 200, 0.004);
  }

  @Test
  void levelThatWantsPings_isGoneOnWith() {
    LadderSearch search = new LadderSearch(PLAN);
    Level begun = new Level(1.5, Approach.OUT, 2, 3);
    assertEquals(Optional.of(new TriedDistance(1.5, Approach.OUT)), search.next(List.of(begun)));
  }

  @Test
  void wrongPlans_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> SweepPlan.ofBearings(2));
    assertThrows(IllegalArgumentException.class, () -> PLAN.with(10, 11, 0.02));
    assertThrows(IllegalArgumentException.class, () -> PLAN.with(10, 5, Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> new Level(1, Approach.IN, 3, 2));
    assertThrows(IllegalArgumentException.class, () -> ThresholdFit.of(List.of(), PLAN));
  }
}
