package simbad.gap.unexplained;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.calibrate.Calibration;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapGain;
import simbad.gap.score.GapMeter;
import simbad.sonar.change.Burst;
import simbad.sonar.effect.Forms;

class UnknownTest {
  private static final Hypothesis OFFSET = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.04);

  private static Signs signs(Hypothesis best, double shrinkage) {
    return Unknown.signs(0, gain(1, 1 - shrinkage, 1 - shrinkage), 1, best, Worlds.POST.scene());
  }

  private static double unknown(Signs signs) {
    return Constants.own().threshold().unknown(signs.byName());
  }

  /** A detour with an offset against it blurs like noise: such a pair takes away little. */
  @Test
  void twoEffectsForLittle_standForSomethingElse() {
    Hypothesis pair =
        OFFSET.and(
            Forms.find(Effect.DROPOUT, "single", Worlds.POST, List.of("s")).orElseThrow(), 0.1);
    assertTrue(signs(pair, 0.19).twoForLittle());
    assertFalse(signs(pair, 0.21).twoForLittle());
    assertFalse(signs(OFFSET, 0.19).twoForLittle());
    assertTrue(unknown(signs(pair, 0.19)) > 3 * unknown(signs(pair, 0.21)));
  }

  @Test
  void whatHangsOnNoPlace_mayStandForSomethingElse() {
    Hypothesis dropout = Worlds.effect(Effect.DROPOUT, "single", 0.1);
    assertTrue(signs(dropout, 0.5).soaks());
    assertTrue(unknown(signs(dropout, 0.5)) > unknown(signs(OFFSET, 0.5)));
    assertTrue(unknown(signs(OFFSET, 0.1)) > unknown(signs(OFFSET, 0.9)));
    assertEquals(0, signs(Hypothesis.NONE, 0).shareLeft());
  }

  private static GapGain gain(double beforeM, double afterM, double expectedM) {
    return new GapGain(
        new GapMeter.Gaps(new double[] {beforeM}, new double[] {0}),
        new GapMeter.Gaps(new double[] {afterM}, new double[] {expectedM}));
  }

  /** Twice as much is left of the gap as the explanation expects of itself. */
  @Test
  void whatIsLeftOfTheGap_speaksForSomethingElse() {
    assertEquals(0, Unknown.left(gain(0.3, 0.04, 0.04), 1), 1e-9);
    assertEquals(Math.log(81.0 / 41), Unknown.left(gain(0.3, 0.08, 0.04), 1), 1e-9);
    assertEquals(0, Unknown.left(gain(0.3, 0.08, 0.04), 2), 1e-9, "a set-up that is off itself");
    assertEquals(Math.log(4), Unknown.left(gain(9, 6, 0.5), 1), 1e-9, "no more than fourfold");
  }

  /** 1 cm more than expected: a twentieth of what was there to take away is 5 mm, or 15. */
  @Test
  void aTwentiethOfTheGap_doesNotMatter() {
    assertFalse(Unknown.isLittle(gain(0.2, 0.11, 0.1), 1));
    assertTrue(Unknown.isLittle(gain(0.4, 0.11, 0.1), 1));
    assertTrue(Unknown.isLittle(gain(0.002, 0.0019, 0.001), 1), "2 mm never do");
  }

  private static boolean standsIn(Effect effect, String form, double... values) {
    return Unknown.isStandIn(
        Worlds.effect(effect, form, values).changes().get(0), Worlds.POST.scene());
  }

  @Test
  void whatNeverWasThere_standsForSomethingElse() {
    assertTrue(standsIn(Effect.DROPOUT, "bursts", 0.3, Burst.LONGEST_PINGS));
    assertFalse(standsIn(Effect.DROPOUT, "bursts", 0.3, 0.9 * Burst.LONGEST_PINGS));
    assertFalse(standsIn(Effect.DROPOUT, "single", 0.3));
    // The post of the scene ends 5 cm from its middle.
    assertTrue(standsIn(Effect.UNMODELLED_OBJECT, "post", 0.09, 0, 0.05, 4, 0.95, 90));
    assertFalse(standsIn(Effect.UNMODELLED_OBJECT, "post", 0.59, 0, 0.05, 4, 0.95, 90));
  }

  /**
   * The same log, the same share of it lost: only how long bursts are said to be differs. A name is
   * said where it is at least 80 % probable.
   */
  @Test
  void standIn_makesTheUnknownProbable() {
    CalibratedLog given =
        Worlds.given(
            Worlds.read(
                Worlds.poses(300, 0.3, 1.3, 1),
                Worlds.effect(Effect.DROPOUT, "bursts", 0.3, 11),
                2));
    Blocks blocks = new Blocks(given.log());
    double[] probability = new double[2];
    for (int i = 0; i < 2; i++) {
      Hypothesis bursts =
          Worlds.effect(Effect.DROPOUT, "bursts", 0.3, i == 0 ? 11 : Burst.LONGEST_PINGS);
      GapGain gain = GapGain.of(given, blocks, bursts);
      probability[i] = unknown(Unknown.signs(given, given, Calibration.none(), gain, bursts));
    }
    assertTrue(probability[0] < 0.1 && probability[1] > 0.2, () -> Arrays.toString(probability));
  }
}
