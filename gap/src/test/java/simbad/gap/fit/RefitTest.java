package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.sensing.ReadingRow;

/** What is fitted again to some of the pings knows nothing of the others. */
class RefitTest {
  private static final int ROWS = 2000;

  private static Form table() {
    return Forms.all(Worlds.POST, List.of("s")).stream()
        .filter(form -> form.effect() == Effect.ORIENTATION_SHADOW)
        .findFirst()
        .orElseThrow();
  }

  /** Heard from half as far on one side. */
  private static Hypothesis lopsided() {
    double[] table = new double[Forms.TABLE_SIZE];
    Arrays.setAll(table, i -> i < table.length / 2 ? 0.75 : 1.5);
    return Hypothesis.NONE.and(table(), table);
  }

  private static Evidence drawn(Hypothesis truth) {
    return Worlds.evidence(Worlds.read(Worlds.poses(ROWS, 0.3, 2.2, 21), truth, 22));
  }

  @Test
  void table_isReadOffThePingsThatCount() {
    Evidence evidence = drawn(lopsided());
    Fold first = ping -> ping % 2 == 0;
    Hypothesis fitted = new Refit(evidence, first).of(lopsided(), 15);
    double[] table = fitted.values();
    double near = Arrays.stream(table, 4, 32).average().orElseThrow();
    double far = Arrays.stream(table, 40, 68).average().orElseThrow();
    assertEquals(0.75, near, 0.08);
    assertEquals(1.5, far, 0.08);
  }

  /** With no ping on one side nothing can be known of it, whatever the start says. */
  @Test
  void table_doesNotKeepWhatOtherPingsTold() {
    List<ReadingRow> rows = Worlds.read(Worlds.poses(ROWS, 0.3, 2.2, 23), lopsided(), 24);
    Evidence evidence = Worlds.evidence(rows);
    Clues clues = new Clues(evidence, Hypothesis.NONE);
    Fold farSide = ping -> clues.geometry.bearingRad(ping) > Math.PI;
    Hypothesis fitted = new Refit(evidence, farSide).of(lopsided(), 15);
    double unseen = Arrays.stream(fitted.values(), 10, 26).average().orElseThrow();
    assertTrue(unseen > 1.2, "mean of the side that was not seen is " + unseen);
  }

  @Test
  void valuesBesideATable_areFittedAsWell() {
    Hypothesis noisy = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.06);
    Hypothesis truth = lopsided().and(noisy.forms().get(0), noisy.values());
    Evidence evidence = drawn(truth);
    Hypothesis start = lopsided().and(noisy.forms().get(0), 0.02);
    Hypothesis fitted = new Refit(evidence, Fold.ALL).of(start, 20);
    assertEquals(0.06, fitted.valuesOf(fitted.effects().indexOf(Effect.RANGE_OFFSET))[0], 0.003);
    assertFalse(fitted.equals(start));
  }
}
