package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.format.MotionData;

/** What is concluded from a few sets that were fitted to a drive. */
class ToldConclusionTest {
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
  private static final MotionForm LATE = MotionForms.find("actuation-latency").orElseThrow();
  private static final MotionForm SCALE = MotionForms.find("speed-scale").orElseThrow();

  private static Told told(Consumer<Drives> world, MotionForm... forms) {
    Drives drives = new Drives(69);
    world.accept(drives);
    MotionData data = drives.data();
    List<MotionRun> runs = data.runs();
    MotionSteps given = new MotionSteps(runs);
    MotionFitter fitter = new MotionFitter(given, CommandUse.of(runs, 0));
    MotionFit none = fitter.asItIs(NONE);
    List<ScoredMotion> sets = new ArrayList<>();
    for (MotionForm form : forms) {
      sets.add(ScoredMotion.of(given, fitter.fit(fitter.screened(new Slopes(given, none), form))));
    }
    sets.add(ScoredMotion.of(given, none));
    Odds odds = new Odds(sets);
    BelievedMotion base = BelievedMotion.of(data);
    List<MotionChain> folds =
        IntStream.range(0, MotionSteps.FOLDS)
            .mapToObj(fold -> odds.best().slopes().withoutFold(fold).chain())
            .toList();
    MotionGap gap = MotionGap.of(runs, base.nominal(), folds);
    return new Told(given, runs, odds, gap, new NoiseFindings(given, base, odds.best().fit()));
  }

  private static List<String> effects(List<MotionFinding> findings) {
    return findings.stream().map(MotionFinding::effect).toList();
  }

  @Test
  void anExactDriveHasNoName() {
    Told told = told(drives -> {}, LATE);
    MotionConclusion conclusion = MotionConclusion.of(told, Optional.empty());

    assertEquals(List.of(), conclusion.named());
    assertEquals(List.of(), conclusion.noises());
    assertEquals(List.of(), conclusion.shadows());
    assertFalse(conclusion.unknown().isLikely());
    assertTrue(conclusion.sure());
    assertEquals(told.gap().ratio(), conclusion.gap(), 0);
    assertEquals(told.gap().floor(told.odds().best().fit().noises()), conclusion.floor(), 0);
    assertEquals(Verdict.NONE, conclusion.verdict());
  }

  @Test
  void whatIsAtWorkIsNamed() {
    Told told = told(drives -> drives.lateS = 0.3, LATE, SCALE);
    MotionConclusion conclusion = MotionConclusion.of(told, Optional.empty());

    assertEquals(List.of(LATE.effect()), effects(conclusion.named()));
    assertTrue(conclusion.sure());
    assertEquals(Verdict.EXPLAINED, conclusion.verdict());
    // The form makes the log likelier by what it takes away, over what hangs together.
    MotionFit best = told.odds().best().fit();
    double[][] without = told.given().residuals(MotionChain.EXACT);
    double lost = best.score() - Whitening.logDensity(told.given(), best.noises(), without);
    assertEquals(lost / told.odds().clumping(), told.gain(LATE), 1e-9);
    assertTrue(told.gain(LATE) > 100);
  }

  /** Beside next to nothing that is left a latency is worth much; what was not found has none. */
  @Test
  void worth_isOfEachEffectOfTheLikeliestSet() {
    Told told = told(drives -> drives.lateS = 0.3, LATE, SCALE);
    double taken =
        told.gap().fitted(MotionChain.EXACT)
            - told.gap().fitted(told.odds().best().hypothesis().chain());
    double left = told.gap().ratio() - told.gap().floor(told.odds().best().fit().noises());
    assertTrue(taken > 0.5, "taken " + taken);
    assertEquals(Map.of(LATE.effect(), MotionSigns.worth(taken, left)), told.worths());
  }

  private static MotionFinding slip(double probability) {
    MotionFinding.Parameter rate =
        new MotionFinding.Parameter(
            "slips_per_minute", 3, new Interval(1, 5), new Interval(0, 99), false);
    return new MotionFinding(
        MotionForms.SLIP, MotionForms.SLIP, probability, List.of(rate), List.of(), "");
  }

  /** Alone it is said, and sure from eight in ten; beside names it is said from nine in ten. */
  @Test
  void slipsThatWereFoundAreSaid() {
    Told exact = told(drives -> {}, LATE);
    MotionConclusion sure = MotionConclusion.of(exact, Optional.of(slip(0.8)));
    MotionConclusion unsure = MotionConclusion.of(exact, Optional.of(slip(0.79)));
    assertEquals(List.of(MotionForms.SLIP), effects(sure.named()));
    assertEquals(List.of(MotionForms.SLIP), effects(unsure.named()));
    assertTrue(sure.sure());
    assertFalse(unsure.sure());

    Told late = told(drives -> drives.lateS = 0.3, LATE);
    MotionConclusion beside = MotionConclusion.of(late, Optional.of(slip(0.9)));
    MotionConclusion vague = MotionConclusion.of(late, Optional.of(slip(0.89)));
    assertEquals(List.of(LATE.effect(), MotionForms.SLIP), effects(beside.named()));
    assertEquals(List.of(LATE.effect()), effects(vague.named()));
    assertEquals(List.of(MotionForms.SLIP), effects(vague.noises()));
    assertTrue(vague.sure());
  }

  /** A robot that goes slower from minute to minute: the scale is its shadow. */
  @Test
  void whatHasNoNameLeavesShadows() {
    Told told =
        told(
            drives -> {
              drives.sag = 0.2;
              drives.speedFactor = 0.95;
            },
            SCALE);
    MotionConclusion conclusion = MotionConclusion.of(told, Optional.empty());

    assertEquals(Set.of(SCALE.effect()), told.odds().best().hypothesis().effects());
    assertTrue(conclusion.unknown().isLikely());
    assertEquals(MotionStrangers.Kind.TIME, kind(conclusion));
    assertEquals(List.of(), conclusion.named());
    assertEquals(List.of(), conclusion.noises());
    assertEquals(Verdict.UNEXPLAINED, conclusion.verdict());
    assertEquals(List.of(SCALE.effect()), conclusion.shadows());
  }

  private static MotionStrangers.Kind kind(MotionConclusion conclusion) {
    return conclusion.unknown().trace().orElseThrow().kind();
  }

  /** What two commands in ten that are lost leave of a latency is no latency. */
  @Test
  void lostCommandsHaveNoName() {
    Told told =
        told(
            drives -> {
              drives.lateS = 0.1;
              drives.dropped = 0.2;
            },
            LATE);
    MotionConclusion conclusion = MotionConclusion.of(told, Optional.empty());

    assertEquals(MotionStrangers.Kind.LOST, kind(conclusion));
    assertEquals(List.of(LATE.effect()), conclusion.shadows());
    assertEquals(Verdict.UNEXPLAINED, conclusion.verdict());
  }

  /** Of a wheel whose size is named it is no wonder that it is not round. */
  @Test
  void aRippleBelongsToTheWheelThatIsNamed() {
    MotionConclusion alone =
        MotionConclusion.of(told(drives -> drives.ripple = 0.2, SCALE), Optional.empty());
    assertEquals(MotionStrangers.Kind.RIPPLE, kind(alone));
    assertEquals(Verdict.UNEXPLAINED, alone.verdict());

    Told scaled =
        told(
            drives -> {
              drives.ripple = 0.2;
              drives.speedFactor = 1.1;
            },
            SCALE);
    MotionConclusion named = MotionConclusion.of(scaled, Optional.empty());
    assertEquals(List.of(SCALE.effect()), effects(named.named()));
    assertEquals(Verdict.EXPLAINED, named.verdict());
    assertFalse(named.unknown().isRipple());
    assertEquals(List.of(), named.noises());
  }

  /** An effect that stands beside what has no name and gains more than that is named. */
  @Test
  void whatIsNeededBesideTheUnnamedIsConfirmed() {
    Told told =
        told(
            drives -> {
              drives.lateS = 0.4;
              drives.sag = 0.3;
            },
            LATE);
    MotionConclusion conclusion = MotionConclusion.of(told, Optional.empty());

    assertEquals(List.of(LATE.effect()), effects(conclusion.named()));
    assertEquals(Verdict.PARTLY, conclusion.verdict());
  }

  @Test
  void scatterIsNamed_aloneOrBesideWhatIsAtWork() {
    MotionConclusion alone =
        MotionConclusion.of(told(drives -> drives.roughness = 0.02, LATE), Optional.empty());
    assertEquals(List.of(MotionForms.MOTION_NOISE), effects(alone.named()));
    assertEquals(List.of(MotionForms.MOTION_NOISE), effects(alone.noises()));
    assertEquals(Verdict.EXPLAINED, alone.verdict());
    Told late =
        told(
            drives -> {
              drives.lateS = 0.3;
              drives.roughness = 0.02;
            },
            LATE);
    MotionConclusion beside = MotionConclusion.of(late, Optional.empty());
    assertEquals(List.of(LATE.effect(), MotionForms.MOTION_NOISE), effects(beside.named()));
  }
}
