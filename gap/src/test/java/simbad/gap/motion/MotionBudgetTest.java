package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/**
 * How a gap is shared out that shrinks by six tenths, of a robot that is too fast and turns far.
 */
class MotionBudgetTest {
  private static final double EXACT = 1e-9;
  private static final MotionForm SCALE = MotionForms.find("speed-scale").orElseThrow();
  private static final MotionForm TURN = MotionForms.find("turn-scale").orElseThrow();
  private static final MotionForm LATE = MotionForms.find("actuation-latency").orElseThrow();
  private static final MotionForm BIAS = MotionForms.find("turn-bias").orElseThrow();
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
  private static final List<MotionRun> RUNS = runs();
  private static final MotionSteps GIVEN = new MotionSteps(RUNS);
  private static final MotionGap GAP =
      MotionGap.of(
          RUNS,
          MotionGap.forecast(RUNS, MotionChain.EXACT),
          Collections.nCopies(MotionSteps.FOLDS, MotionChain.EXACT));

  private static List<MotionRun> runs() {
    Drives drives = new Drives(91);
    drives.seconds = 60;
    drives.speedFactor = 1.2;
    drives.turnFactor = 1.1;
    return drives.data().runs();
  }

  private static final Noise[] BELIEVED = {
    Noise.believed(1e-4), Noise.believed(1e-4), Noise.believed(2e-4)
  };

  private static MotionDiagnosis.Gap figures(double ratio, double floor) {
    double[][] none = new double[3][3];
    Interval here = new Interval(ratio - 0.1, ratio + 0.1);
    return new MotionDiagnosis.Gap(9, none, none, none, ratio, here, new Interval(0, 2), floor);
  }

  private static List<MotionDiagnosis.Part> parts(
      MotionDiagnosis.Gap figures, MotionHypothesis set, String... named) {
    MotionFitter fitter = new MotionFitter(GIVEN, CommandUse.of(RUNS, 0));
    ScoredMotion best = ScoredMotion.of(GIVEN, fitter.asItIs(set));
    return new MotionBudget(GAP, figures, best, BELIEVED)
        .of(
            Arrays.stream(named)
                .map(one -> new MotionFinding(one, one, 0.9, List.of(), List.of(), ""))
                .toList());
  }

  private static void assertPart(
      MotionDiagnosis.Part part, String what, double share, double low, double high) {
    assertEquals(what, part.what());
    assertEquals(share, part.share(), EXACT);
    assertEquals(low, part.ci95().low(), EXACT);
    assertEquals(high, part.ci95().high(), EXACT);
  }

  private static double sum(List<MotionDiagnosis.Part> parts) {
    return parts.stream().mapToDouble(MotionDiagnosis.Part::share).sum();
  }

  private static double without(MotionHypothesis set, MotionForm form) {
    return GAP.fitted(set.without(form).chain()) - GAP.fitted(set.chain());
  }

  @Test
  void effectsShareByWhatEachAloneWouldLeave() {
    MotionHypothesis both = NONE.with(SCALE, new double[] {1.2}).with(TURN, new double[] {1.1});
    List<MotionDiagnosis.Part> parts =
        parts(figures(0.4, 0.15), both, SCALE.effect(), TURN.effect());
    double speed = without(both, SCALE);
    double turn = without(both, TURN);
    double share = speed / (speed + turn);

    assertTrue(speed > 0.1 && turn > 0.1, () -> speed + " and " + turn);
    assertEquals(4, parts.size());
    assertPart(parts.get(0), "speed-scale", share * 0.6, share * 0.5, share * 0.7);
    double other = 1 - share;
    assertPart(parts.get(1), "turn-scale", other * 0.6, other * 0.5, other * 0.7);
    assertPart(parts.get(2), "rest", 0.25, 0.15, 0.35);
    assertPart(parts.get(3), "floor", 0.15, 0.05, 0.25);
    assertEquals(1, sum(parts), EXACT);
  }

  /** What costs nothing alone has next to nothing beside what does, and half beside its like. */
  @Test
  void whatChangesNothingHasHardlyAShare() {
    MotionHypothesis idle = NONE.with(LATE, new double[] {0}).with(BIAS, new double[] {0});
    List<MotionDiagnosis.Part> like = parts(figures(0.4, 0.15), idle, LATE.effect(), BIAS.effect());
    assertPart(like.get(0), LATE.effect(), 0.3, 0.25, 0.35);
    assertPart(like.get(1), BIAS.effect(), 0.3, 0.25, 0.35);

    MotionHypothesis beside = idle.with(SCALE, new double[] {1.2});
    List<MotionDiagnosis.Part> parts =
        parts(figures(0.4, 0.15), beside, LATE.effect(), SCALE.effect());
    assertTrue(parts.get(0).share() > 0 && parts.get(0).share() < 1e-8);
    assertEquals(0.6, parts.get(1).share(), 1e-7);
  }

  /** Names that only scatter have no share of what shrinks. */
  @Test
  void scatterBeyondTheTrackersBelongsToItsNames() {
    MotionHypothesis one = NONE.with(SCALE, new double[] {1.2});
    double tracker = GAP.floor(BELIEVED);
    assertTrue(tracker > 0.001 && tracker < 0.3, () -> "tracker " + tracker);
    List<MotionDiagnosis.Part> parts =
        parts(figures(0.4, 0.3), one, SCALE.effect(), MotionForms.SLIP, MotionForms.MOTION_NOISE);
    double each = (0.3 - tracker) / 2;

    assertEquals(5, parts.size());
    assertPart(parts.get(0), SCALE.effect(), 0.6, 0.5, 0.7);
    assertPart(parts.get(1), MotionForms.SLIP, each, Math.max(0, each - 0.1), each + 0.1);
    assertPart(parts.get(2), MotionForms.MOTION_NOISE, each, Math.max(0, each - 0.1), each + 0.1);
    assertPart(parts.get(3), "rest", 0.1, 0, 0.2);
    assertPart(parts.get(4), "floor", tracker, Math.max(0, tracker - 0.1), tracker + 0.1);
    assertEquals(1, sum(parts), EXACT);
  }

  @Test
  void withoutANameNothingIsTaken() {
    List<MotionDiagnosis.Part> parts =
        parts(figures(0.4, 0.3), NONE.with(SCALE, new double[] {1.2}));

    assertEquals(2, parts.size());
    assertPart(parts.get(0), "rest", 0.7, 0.6, 0.8);
    assertPart(parts.get(1), "floor", 0.3, 0.2, 0.4);
  }

  /** Less than the floor cannot be left of it. */
  @Test
  void theFloorIsNoMoreThanWhatIsLeft() {
    List<MotionDiagnosis.Part> parts =
        parts(figures(0.125, 0.3), NONE.with(SCALE, new double[] {1.2}), SCALE.effect());

    assertPart(parts.get(0), SCALE.effect(), 0.875, 0.775, 0.975);
    assertPart(parts.get(1), "rest", 0, 0, 0.1);
    assertPart(parts.get(2), "floor", 0.125, 0.025, 0.225);
  }
}
