package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.MotionChain;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.format.MotionData;

/**
 * What a reference shows belongs to the set-up, and only what is otherwise in a log is a change.
 */
class ReferenceTest {
  private static MotionData drive(long seed, Consumer<Drives> world) {
    Drives drives = new Drives(seed);
    world.accept(drives);
    return drives.data();
  }

  private static MotionData beside(MotionData log, MotionData reference) {
    return new MotionData("drive", log.robot(), log.runs(), reference.runs());
  }

  /** Off by less than anybody would name, in four ways at once. */
  private static void aLittleOff(Drives drives) {
    drives.speedFactor = 1.004;
    drives.turnFactor = 0.995;
    drives.turnPerMetre = 0.009;
    drives.lagS = 0.014;
    drives.roughness = 0.004;
  }

  @ParameterizedTest
  @ValueSource(longs = {200, 201})
  void whatBothShow_isNoChange(long seed) {
    MotionData data =
        beside(drive(seed, ReferenceTest::aLittleOff), drive(seed + 50, ReferenceTest::aLittleOff));

    MotionDiagnosis diagnosis = new MotionDiagnoser(data).diagnose();

    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.headline());
  }

  @Test
  void aChange_isNamedWithItsOwnValue() {
    MotionData log =
        drive(
            210,
            drives -> {
              aLittleOff(drives);
              drives.speedFactor = 1.05;
            });

    MotionDiagnosis diagnosis =
        new MotionDiagnoser(beside(log, drive(211, ReferenceTest::aLittleOff))).diagnose();

    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.headline());
    assertEquals(List.of("speed-scale"), effects(diagnosis.findings()));
    double factor = diagnosis.findings().get(0).parameters().get(0).value();
    assertEquals(1.05 / 1.004, factor, 0.003);
  }

  private static List<String> effects(List<MotionFinding> findings) {
    return findings.stream().map(MotionFinding::effect).toList();
  }

  /** The same robot on two days, whose scatter is larger than its file says. */
  @Test
  void scatterOfBoth_isNoNoise() {
    MotionData data =
        beside(drive(220, d -> d.roughness = 0.02), drive(221, d -> d.roughness = 0.02));

    MotionDiagnosis diagnosis = new MotionDiagnoser(data).diagnose();

    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.headline());
  }

  /**
   * A curve of a millirad per metre is a few hundredths of a practical one and shows in no
   * reference of a minute; ten times the practical size is no set-up's.
   */
  @Test
  void learning_takesWhatTheReferenceDoesNotSpeakAgainst() {
    MotionData reference = drive(230, drives -> drives.seconds = 70);
    BelievedMotion believed = BelievedMotion.of(beside(reference, reference));

    BelievedMotion learnt = believed.learning(found(believed, 0.001), form -> 100).orElseThrow();

    FittedMotion last = learnt.shown().get(learnt.shown().size() - 1);
    assertEquals("wheel-asymmetry", last.form().effect());
    MotionChain chain = believed.nominal().chain().with(last.change());
    assertEquals(chain.turn(0, 1), learnt.nominal().chain().turn(0, 1), 1e-12);
    assertTrue(believed.learning(found(believed, 0.2), form -> 100).isEmpty());
    // Of 5 nats that the log gains no more can be lost by what both have in common.
    assertTrue(believed.learning(found(believed, 0.2), form -> 5).isPresent());
  }

  private static ScoredMotion found(BelievedMotion believed, double perMetre) {
    MotionForm form = MotionForms.find("wheel-asymmetry").orElseThrow();
    MotionSteps given = believed.reference().orElseThrow().given();
    MotionHypothesis set =
        new MotionHypothesis(believed.nominal().chain(), List.of(), new double[0])
            .with(form, new double[] {perMetre});
    MotionFit fit = new MotionFit(set, given.residuals(set.chain()), believed.noises(), 0);
    return ScoredMotion.of(given, fit);
  }

  /** Without a reference nothing is learnt: the robot's file is what is believed. */
  @Test
  void withoutReference_nothingIsLearnt() {
    MotionData log = drive(240, drives -> {});
    BelievedMotion stated = BelievedMotion.of(log);
    BelievedMotion calibrated = BelievedMotion.of(beside(log, log));

    assertTrue(stated.reference().isEmpty());
    assertTrue(stated.learning(found(calibrated, 0.01), form -> 100).isEmpty());
  }
}
