package simbad.gap.explain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.junit.jupiter.api.Test;
import simbad.gap.explain.GapMeter.Gaps;

/** By what chance a gap is as large as it is. */
class GapsTest {
  private static final double LOST_M = 4;

  /** Pings of which each is lost rarely; some are. */
  private static Gaps losses(int pings, double probability, int lost) {
    Gaps gaps = Gaps.empty(pings);
    Arrays.fill(gaps.observedM(), 0, lost, LOST_M);
    Arrays.fill(gaps.expectedM(), probability * LOST_M);
    Arrays.fill(gaps.squareM2(), probability * LOST_M * LOST_M);
    return gaps;
  }

  private static Gain gain(Gaps gaps) {
    return new Gain(gaps, gaps);
  }

  /** The mean square of an exponential distribution is twice the square of its mean. */
  @Test
  void onePingOfAnExponentialDistribution_isItsTail() {
    Gaps one = new Gaps(new double[] {3}, new double[] {2}, new double[] {8});
    assertEquals(Math.exp(-1.5), one.chance(1, 1), 1e-12);
  }

  /** Twice as many events: Erlang's distribution of two, exp(-x) (1 + x). */
  @Test
  void twiceWhatIsExpected_isTwiceAsManyEvents() {
    Gaps one = new Gaps(new double[] {9}, new double[] {2}, new double[] {8});
    assertEquals(Math.exp(-4.5) * 5.5, one.chance(2, 1), 1e-12);
  }

  /** Pings that come in twos are half as many, each of twice the size. */
  @Test
  void clumping_makesFewerAndLargerEvents() {
    Gaps two = new Gaps(new double[] {3, 3}, new double[] {2, 2}, new double[] {8, 8});
    assertEquals(Math.exp(-1.5), two.chance(1, 2), 1e-12);
  }

  @Test
  void whereNothingCanHappen_anythingIsNoChance() {
    Gaps never = new Gaps(new double[] {0, 0}, new double[2], new double[2]);
    assertEquals(1, never.chance(2, 1));
    Gaps seen = new Gaps(new double[] {0, 0.1}, new double[2], new double[2]);
    assertEquals(0, seen.chance(2, 1));
  }

  /** Two echoes lost where half a one is expected: four times as much, and chance all the same. */
  @Test
  void fewRareEvents_areNoProof() {
    assertFalse(gain(losses(1000, 0.0005, 2)).leavesMuch());
    assertTrue(gain(losses(40_000, 0.0005, 80)).leavesMuch());
    assertFalse(gain(losses(40_000, 0.0005, 30)).leavesMuch());
  }

  @Test
  void whatASetupThatMovesTakesUp_isNotLeft() {
    Gaps far = losses(40_000, 0.0005, 80);
    assertFalse(gain(far).beside(losses(40_000, 0.0015, 80), 1).leavesMuch());
    assertEquals(LOST_M * 0.0015, gain(far).beside(losses(40_000, 0.0015, 80), 1).floorM(), 1e-12);
  }
}
