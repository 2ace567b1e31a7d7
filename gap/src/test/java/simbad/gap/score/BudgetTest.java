package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.BudgetEntry;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;

/** What a gap is made of, in worlds whose effects are known. */
class BudgetTest {
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.06);

  private static List<BudgetEntry> of(Hypothesis truth) {
    CalibratedLog given = Worlds.given(Worlds.read(Worlds.poses(600, 0.3, 1.3, 1), truth, 2));
    Blocks blocks = new Blocks(given.log());
    GapGain gain = GapGain.of(given, blocks, truth);
    List<BudgetEntry> budget = Budget.of(given, blocks, truth, gain, 3);
    double sum = budget.stream().mapToDouble(BudgetEntry::cm).sum();
    assertEquals(100 * gain.beforeM(), sum, 1e-9, "the parts are the whole");
    for (BudgetEntry entry : budget) {
      assertTrue(entry.ci95().low() <= entry.cm() + 1e-9, entry.toString());
      assertTrue(entry.ci95().high() >= entry.cm() - 1e-9, entry.toString());
    }
    return budget;
  }

  @Test
  void nothing_isRestAndFloor() {
    List<BudgetEntry> budget = of(Hypothesis.NONE);
    assertEquals(
        List.of(BudgetEntry.REST, BudgetEntry.FLOOR),
        budget.stream().map(BudgetEntry::what).toList());
  }

  /** Of one effect its share is all that the gap shrinks by. */
  @Test
  void oneEffect_hasAllThatItShrinks() {
    List<BudgetEntry> budget = of(OFFSET);
    assertEquals("range-offset", budget.get(0).what());
    assertTrue(budget.get(0).cm() > 3, budget.toString());
    assertTrue(budget.get(1).ci95().low() < 0.1, "none but chance: " + budget);
  }

  /** Lost echoes and a shift hardly touch each other: each has about its own. */
  @Test
  void twoEffects_shareByWhatEachTakesAway() {
    Hypothesis dropout = Worlds.effect(Effect.DROPOUT, "single", 0.3);
    Hypothesis both = OFFSET.and(dropout.forms().get(0), dropout.values());
    List<BudgetEntry> budget = of(both);
    double offsetAlone = of(OFFSET).get(0).cm();
    assertEquals(
        List.of("range-offset", "dropout", "rest", "floor"),
        budget.stream().map(BudgetEntry::what).toList());
    assertEquals(0.7 * offsetAlone, budget.get(0).cm(), 1.5, budget.toString());
    assertTrue(budget.get(1).cm() > 1, budget.toString());
  }
}
