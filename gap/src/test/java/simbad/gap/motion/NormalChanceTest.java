package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class NormalChanceTest {
  /** From any table of the normal distribution. */
  @Test
  void below_isTheNormalDistribution() {
    assertEquals(0.5, NormalChance.below(0), 1e-12);
    assertEquals(0.97500, NormalChance.below(1.959964), 1e-6);
    assertEquals(0.00135, NormalChance.below(-3), 1e-5);
    assertEquals(1.644854, NormalChance.deviate(0.95), 1e-6);
  }

  @Test
  void logOdds_areProbabilities() {
    assertEquals(0.5, NormalChance.ofLogOdds(0));
    assertEquals(0.75, NormalChance.ofLogOdds(Math.log(3)), 1e-12);
  }
}
