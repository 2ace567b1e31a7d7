package simbad.gap.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Forms;

class UnknownTest {
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.04);

  /** A detour with an offset against it blurs like noise: such a pair takes away little. */
  @Test
  void twoEffectsForLittle_standForSomethingElse() {
    Hypothesis pair =
        OFFSET.and(
            Forms.find(Effect.DROPOUT, "single", Worlds.POST, List.of("s")).orElseThrow(), 0.1);
    assertTrue(Unknown.named(pair, 0.19) > Unknown.named(pair, 0.21) + 2);
    assertEquals(Unknown.named(OFFSET, 0.19), Unknown.named(OFFSET, 0.21), 0.03);
  }

  @Test
  void whatHangsOnNoPlace_mayStandForSomethingElse() {
    Hypothesis dropout = Worlds.effect(Effect.DROPOUT, "single", 0.1);
    assertTrue(Unknown.named(dropout, 0.5) > Unknown.named(OFFSET, 0.5));
    assertTrue(Unknown.named(OFFSET, 0.1) > Unknown.named(OFFSET, 0.9));
  }
}
