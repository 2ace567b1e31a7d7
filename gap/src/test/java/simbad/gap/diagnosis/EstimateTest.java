package simbad.gap.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class EstimateTest {
  private static final Estimate OPEN = new Estimate(3, Double.POSITIVE_INFINITY);

  /** Of two that are known alike the mean is known better by the root of two. */
  @Test
  void two_areTheirProduct() {
    Estimate both = new Estimate(1, 0.2).and(new Estimate(2, 0.2));
    assertEquals(1.5, both.value(), 1e-12);
    assertEquals(0.2 / Math.sqrt(2), both.deviation(), 1e-12);
  }

  @Test
  void whatIsOpen_changesNothing() {
    Estimate known = new Estimate(1, 0.2);
    assertEquals(known, OPEN.and(known));
    assertEquals(known.value(), known.and(OPEN).value());
    assertEquals(known.deviation(), known.and(OPEN).deviation(), 1e-12);
    assertTrue(known.agrees(OPEN, 0));
  }

  @Test
  void farApart_theyDisagree_unlessNobodyWouldMind() {
    Estimate one = new Estimate(1, 0.001);
    Estimate other = new Estimate(1.01, 0.001);
    assertFalse(one.agrees(other, 0.005));
    assertTrue(one.agrees(other, 0.02));
    assertTrue(one.agrees(new Estimate(1.005, 0.001), 0));
  }

  @Test
  void noDeviation_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Estimate(1, 0));
    assertThrows(IllegalArgumentException.class, () -> new Estimate(1, Double.NaN));
  }
}
