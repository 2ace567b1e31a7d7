package simbad.gap.calibrate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.sonar.catalogue.SetupForms;

/** What a reference says of the explanation of a log that came later. */
class SuspicionTest {
  private static Hypothesis offset(double metres) {
    return Worlds.effect(Effect.RANGE_OFFSET, "constant", metres);
  }

  private static CalibratedLog log(Hypothesis truth, int rows, long seed) {
    return Worlds.given(Worlds.read(Worlds.poses(rows, 0.3, 1.4, seed), truth, seed + 1));
  }

  private static Hypothesis settled(
      CalibratedLog reference, Hypothesis truth, Hypothesis explanation, double clumping) {
    return new Suspicion(reference, log(truth, 600, 3), explanation, clumping)
        .settled(Hypothesis.NONE, 0);
  }

  @Test
  void whatTheReferenceShowsToo_isOfTheSetup() {
    Hypothesis found = settled(log(offset(0.03), 600, 1), offset(0.03), offset(0.03), 1);
    assertEquals(List.of(SetupForms.of(offset(0.03).forms().get(0))), found.forms());
    assertEquals(0.03, found.values()[0], 0.002);
  }

  @Test
  void whatTheReferenceRulesOut_isOfTheLog() {
    Hypothesis found = settled(log(Hypothesis.NONE, 600, 1), offset(0.03), offset(0.03), 1);
    assertSame(Hypothesis.NONE, found);
  }

  /** A reference that is 4 mm off shows something, but not the 4 cm of the log. */
  @Test
  void whatTheReferenceShowsOfAnotherSize_isOfTheLog() {
    Hypothesis found = settled(log(offset(0.004), 2000, 1), offset(0.04), offset(0.04), 1);
    assertSame(Hypothesis.NONE, found);
  }

  /** 2 of 4 cm explain three quarters of what 4 cm do where the likelihood is a parabola. */
  @Test
  void whatTheReferenceShowsOfAKindredSize_isOfTheSetup() {
    Hypothesis found = settled(log(offset(0.02), 600, 1), offset(0.04), offset(0.04), 1);
    assertEquals(0.02, found.values()[0], 0.002);
  }

  /** Where readings hang together so much, what a reference gains is no sign of anything. */
  @Test
  void whatTheReferenceHardlyShows_isOfTheLog() {
    Hypothesis found = settled(log(offset(0.03), 600, 1), offset(0.03), offset(0.03), 1e6);
    assertSame(Hypothesis.NONE, found);
  }

  /** Five pings rule nothing out: what hardly shrinks the gap is the set-up's, what does is not. */
  @Test
  void whatTheReferenceLeavesOpen_isOfTheSetupIfItIsSmall() {
    CalibratedLog few = log(Hypothesis.NONE, 5, 1);
    Hypothesis small = offset(0.001);
    Hypothesis found = settled(few, small, small, 1);
    assertEquals(List.of(SetupForms.of(small.forms().get(0))), found.forms());
    assertEquals(0.001, found.values()[0]);
    Hypothesis gain = Worlds.effect(Effect.GAIN, "factor", 0.8);
    assertSame(Hypothesis.NONE, settled(few, gain, gain, 1));
  }

  @Test
  void whatIsKnownAlready_staysAsItIs() {
    Hypothesis known = Hypothesis.NONE.and(SetupForms.of(offset(0.03).forms().get(0)), 0.03);
    Suspicion suspicion =
        new Suspicion(log(offset(0.03), 100, 1), log(offset(0.03), 100, 3), offset(0.03), 1);
    assertSame(known, suspicion.settled(known, 0));
  }
}
