package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.motion.MotionChain;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/** Forms with values: a lag of two, a latency, and half as fast again. */
class MotionHypothesisTest {
  private static final MotionForm LAG =
      MotionForms.find("actuation-lag: time constants").orElseThrow();
  private static final MotionForm LATE = MotionForms.find("actuation-latency").orElseThrow();
  private static final MotionForm SCALE = MotionForms.find("speed-scale").orElseThrow();
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
  private static final MotionHypothesis ALL =
      NONE.with(LAG, new double[] {0.2, 0.3})
          .with(LATE, new double[] {0.1})
          .with(SCALE, new double[] {1.5});

  @Test
  void eachFormHasItsValues() {
    assertArrayEquals(new double[] {0.2, 0.3, 0.1, 1.5}, ALL.values(), 0);
    assertArrayEquals(new double[] {0.2, 0.3}, ALL.values(LAG), 0);
    assertArrayEquals(new double[] {0.1}, ALL.values(LATE), 0);
    assertArrayEquals(new double[] {1.5}, ALL.values(SCALE), 0);
    assertThrows(IllegalArgumentException.class, () -> NONE.values(LAG));
    assertEquals(4, ALL.parameters().size());
    assertEquals(LATE.parameters().get(0), ALL.parameters().get(2));
    assertEquals(List.of(LAG, LATE, SCALE), ALL.fitted().stream().map(f -> f.form()).toList());
  }

  @Test
  void formsActOneAfterTheOther() {
    assertEquals(0.1, ALL.chain().delayS(), 1e-12);
    assertEquals(0, NONE.chain().delayS(), 0);
    // Half as fast again; behind what is believed already.
    assertEquals(0.15, ALL.chain().speed(0.1, 0), 1e-12);
    MotionHypothesis more = new MotionHypothesis(ALL.chain(), List.of(LATE), new double[] {0.2});
    assertEquals(0.3, more.chain().delayS(), 1e-12);
    assertEquals(4, more.chain().changes().size());
  }

  @Test
  void aFormIsTakenAwayWithItsValues() {
    MotionHypothesis less = ALL.without(LATE);

    assertEquals(List.of(LAG, SCALE), less.forms());
    assertArrayEquals(new double[] {0.2, 0.3, 1.5}, less.values(), 0);
    assertEquals(0, less.chain().delayS(), 0);
    assertArrayEquals(new double[] {0.1, 1.5}, ALL.without(LAG).values(), 0);
    assertArrayEquals(new double[] {0.1, 1.5}, ALL.without(LAG.effect()).values(), 0);
    assertEquals(3, ALL.without("no-such-effect").forms().size());
  }

  /** Only the change of its form is made anew. */
  @Test
  void oneValueIsChanged() {
    MotionHypothesis other = ALL.withValue(2, 0.15);
    assertArrayEquals(new double[] {0.2, 0.3, 0.15, 1.5}, other.values(), 0);
    assertEquals(0.15, other.chain().delayS(), 1e-12);
    assertSame(ALL.changes().get(0), other.changes().get(0));
    assertSame(ALL.changes().get(2), other.changes().get(2));
    assertEquals(0.1, ALL.chain().delayS(), 1e-12);

    MotionHypothesis last = ALL.withValue(3, 2);
    assertEquals(0.2, last.chain().speed(0.1, 0), 1e-12);
    assertSame(ALL.changes().get(1), last.changes().get(1));
    assertSame(ALL.changes().get(2), ALL.withValue(0, 0.5).changes().get(2));
  }

  @Test
  void effectsAreNamedOnce() {
    assertEquals(Set.of(LAG.effect(), LATE.effect(), SCALE.effect()), ALL.effects());
    assertTrue(ALL.names(LATE.effect()));
    assertFalse(ALL.without(LATE).names(LATE.effect()));
    assertEquals(Set.of(), NONE.effects());
  }

  /** Each value promises less on other logs. */
  @Test
  void aFitPromisesLessForEachValue() {
    MotionFit fit = new MotionFit(ALL, new double[0][0], new Noise[0], 100);

    assertEquals(100 - 4 * 1.5, fit.promise(1.5), 1e-12);
  }
}
