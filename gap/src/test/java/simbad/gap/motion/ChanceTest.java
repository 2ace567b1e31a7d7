package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class ChanceTest {
  /** From any table of the normal distribution. */
  @Test
  void below_isTheNormalDistribution() {
    assertEquals(0.5, Chance.below(0), 1e-12);
    assertEquals(0.97500, Chance.below(1.959964), 1e-6);
    assertEquals(0.00135, Chance.below(-3), 1e-5);
  }

  @Test
  void whatWasChosenAmongMany_isLessSure() {
    assertEquals(1 - 16 * 0.00134990, Chance.chosen(3, 16), 1e-6);
    assertEquals(0, Chance.chosen(0, 16));
    assertEquals(Chance.below(2), Chance.chosen(2, 1), 1e-12);
  }
}
