package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.gap.motion.MotionStrangers.Kind;
import simbad.gap.motion.MotionStrangers.Trace;

/** What traces say of something without a name: 8 nats to be there, and half for each value. */
class MotionUnknownTest {
  private static final double EXACT = 1e-12;

  private static Trace trace(Kind kind, double nats, int values, double share) {
    return new Trace(kind, 0, nats, values, share);
  }

  private static MotionUnknown unknown(double events, Trace... traces) {
    return new MotionUnknown(List.of(traces), events);
  }

  private static double chance(double logOdds) {
    return 1 / (1 + Math.exp(-logOdds));
  }

  /** 13 nats with four values gain 3, which count for 1.2. */
  @Test
  void aTraceGainsWhatIsMoreThanChance() {
    Trace trace = trace(Kind.TIME, 13, 4, 1);

    assertEquals(3, MotionUnknown.gain(trace), EXACT);
    assertEquals(chance(1.2), unknown(0, trace).probability(), EXACT);
    assertTrue(unknown(0, trace).isLikely());
    assertFalse(unknown(0, trace(Kind.TIME, 9, 4, 1)).isLikely());
  }

  /** Of 1.5 % of what is left over it makes no odds; of 1.2 % they are 8 times a fifth less. */
  @Test
  void whatForetellsLittleIsNoMatter() {
    assertEquals(0.5, unknown(0, trace(Kind.TIME, 99, 0, 0.015)).probability(), EXACT);
    assertEquals(
        chance(-8 * 0.2 / 2.5), unknown(0, trace(Kind.TIME, 99, 0, 0.012)).probability(), 1e-9);
    assertEquals(chance(8 / 2.5), unknown(0, trace(Kind.TIME, 99, 0, 0.03)).probability(), 1e-9);
  }

  @Test
  void theLikeliestCounts() {
    MotionUnknown both = unknown(0.3, trace(Kind.TIME, 13, 4, 1), trace(Kind.SIDE, 18, 0, 1));

    assertEquals(chance(4), both.probability(), EXACT);
    assertEquals(Kind.SIDE, both.trace().orElseThrow().kind());
    assertEquals(Kind.SIDE.words(), both.words());
    assertEquals(chance(1.2), both.without(Kind.SIDE).probability(), EXACT);
    assertEquals(0.3, both.without(Kind.SIDE).without(Kind.TIME).probability(), 0);
    assertEquals(0, unknown(0).probability(), 0);
  }

  /** An event says more than a trace that is unlikely, less than one that is likely. */
  @Test
  void eventsAreWhatNoTraceShows() {
    MotionUnknown events = unknown(0.9, trace(Kind.TIME, 7, 0, 1));
    assertEquals(Optional.empty(), events.trace());
    assertEquals("now and then it is far off, in either direction", events.words());
    assertEquals(0.9, events.probability(), 0);
    assertTrue(unknown(0.9, trace(Kind.TIME, 9, 0, 1)).trace().isPresent());
    assertTrue(unknown(0.1, trace(Kind.TIME, 7, 0, 1)).trace().isPresent());
  }

  @Test
  void aRippleIsSeenHoweverLittleItForetells() {
    assertTrue(unknown(0, trace(Kind.RIPPLE, 9, 0, 0)).isRipple());
    assertFalse(unknown(0, trace(Kind.RIPPLE, 8, 0, 1)).isRipple());
    assertFalse(unknown(0, trace(Kind.TIME, 99, 0, 1)).isRipple());
  }

  /** Twice what matters: 3 % of what is left over. */
  @Test
  void scatterIsATraceToo() {
    assertEquals(new Trace(Kind.SCATTER, 0, 12, 0, 0.03), MotionUnknown.scatter(12, 2));
  }

  @Test
  void signsAreNumbersByName() {
    MotionSigns named = new MotionSigns(true, -2, 0.25, Map.of());
    MotionSigns alone = new MotionSigns(false, -2, 0.25, Map.of());

    assertEquals(List.of(1.0, -2.0, -2.0, 0.25, 0.0), List.copyOf(named.byName().values()));
    assertEquals(List.of(0.0, -2.0, 0.0, 0.0, 0.25), List.copyOf(alone.byName().values()));
    assertEquals(
        List.of("named", "stranger", "stranger_beside", "left_beside", "left_alone"),
        List.copyOf(alone.byName().keySet()));
  }

  @Test
  void aFindingMayBecomeLessProbable() {
    MotionFinding.Parameter value =
        new MotionFinding.Parameter("p", 1, new Interval(0, 2), new Interval(-5, 5), false);
    MotionFinding finding =
        new MotionFinding("lag", "lag: one", 0.8, List.of(value), List.of("delay"), "wait");

    assertEquals(0.5, finding.atMost(0.5).probability(), 0);
    assertEquals(0.8, finding.atMost(0.9).probability(), 0);
    assertEquals(0.2, finding.times(0.25).probability(), EXACT);
    assertEquals("turn", finding.with("turn").remedy());
    assertEquals(finding, finding.with("turn").with("wait"));
    assertEquals(finding.with("x"), finding.times(1).with("x"));
    assertThrows(IllegalArgumentException.class, () -> finding.times(Double.NaN));
  }

  @Test
  void aPlaceRefusesWhatIsNoNumber() {
    for (int i = 0; i < 6; i++) {
      double[] v = {1, 2, 0.5, 1.5, 0.5, 0.01};
      v[i] = Double.NaN;
      assertThrows(
          IllegalArgumentException.class,
          () -> new MotionPlace("t_s", "", v[0], v[1], 3, v[2], v[3], v[4], "along", v[5]),
          "figure " + i);
    }
  }
}
