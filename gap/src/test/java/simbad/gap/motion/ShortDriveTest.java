package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Estimate;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.score.IntervalWidths;
import simbad.motion.MotionChain;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.format.MotionData;

/** A log of thirty seconds, too short to diagnose: what it says of single values beside others. */
class ShortDriveTest {
  private static final MotionForm SCALE = form("speed-scale");
  private static final MotionForm GROWING = form("speed-scale: growing with the speed");
  private static final MotionForm WHEELS = form("wheel-scale");
  private static final MotionForm TURN = form("turn-scale");
  private static final MotionForm LATE = form("actuation-latency");
  private static final MotionDiagnoser DIAGNOSER = new MotionDiagnoser(data());
  private static final MotionDiagnosis SILENT = DIAGNOSER.diagnose();

  private static MotionForm form(String name) {
    return MotionForms.find(name).orElseThrow();
  }

  private static MotionData data() {
    Drives drives = new Drives(66);
    drives.seconds = 30;
    drives.speedFactor = 1.2;
    drives.turnFactor = 1.1;
    return drives.data();
  }

  @Test
  void aShortLogSaysNothing() {
    assertEquals(Verdict.UNDECIDED, SILENT.verdict());
    assertEquals(
        "the track covers only 3 of the 6 stretches of ten seconds that are needed",
        SILENT.headline());
    assertTrue(SILENT.isSilent());
    assertEquals(List.of(), SILENT.findings());
    assertEquals(
        MotionForms.vocabulary(), SILENT.others().stream().map(MotionFinding::effect).toList());
    assertTrue(SILENT.others().stream().allMatch(one -> one.probability() == 0));
    assertEquals(0.5, SILENT.unknownProbability(), 0);
    assertEquals(1, SILENT.gap().ratio(), 0);
    assertEquals(List.of(new MotionDiagnosis.Part("rest", 1, new Interval(0, 1))), SILENT.budget());
    assertEquals(MotionChain.EXACT, SILENT.forecast().chain());
    assertEquals(0, SILENT.probability(Verdict.NONE), 0);
  }

  /** What was not found is fitted beside what was. */
  @Test
  void anEstimateIsThatOfTheLog() {
    Estimate speed = DIAGNOSER.estimate(SILENT, SCALE);

    assertEquals(1.2, speed.value(), 0.01);
    assertTrue(speed.deviation() > 0 && speed.deviation() < 0.01);
    MotionDiagnosis found = DIAGNOSER.with(SILENT, SCALE, 1.2);
    assertEquals(1.1, DIAGNOSER.estimate(found, TURN).value(), 0.01);
  }

  /** What was found is taken as it stands. */
  @Test
  void aFoundValueIsNotFittedAgain() {
    MotionDiagnosis late = DIAGNOSER.with(SILENT, LATE, 0.05);
    MotionDiagnosis both = DIAGNOSER.with(late, SCALE, 1.25);

    assertEquals(1.25, DIAGNOSER.estimate(both, SCALE).value(), 0);
    assertEquals(0.05, DIAGNOSER.estimate(both, LATE).value(), 0);
    double[] errors = errors(0.05, 1.25);
    double wider = IntervalWidths.own().motion();
    assertEquals(wider * errors[0], DIAGNOSER.estimate(both, LATE).deviation(), 1e-9);
    assertEquals(wider * errors[1], DIAGNOSER.estimate(both, SCALE).deviation(), 1e-9);
  }

  private static double[] errors(double late, double scale) {
    MotionSteps given = new MotionSteps(data().runs());
    MotionHypothesis set =
        new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0])
            .with(LATE, new double[] {late})
            .with(SCALE, new double[] {scale});
    double[][] residuals = given.residuals(set.chain());
    MotionFit fit = new MotionFit(set, residuals, NoiseFit.afresh(given, residuals), 0);
    return new Slopes(given, fit).standardErrors();
  }

  private static List<MotionForm> forms(MotionDiagnosis diagnosis) {
    return diagnosis.fitted().stream().map(FittedMotion::form).toList();
  }

  private static double[] values(MotionDiagnosis diagnosis) {
    return diagnosis.fitted().stream().flatMapToDouble(f -> Arrays.stream(f.values())).toArray();
  }

  /** What says the same in other words gives way, and so does another value of it. */
  @Test
  void anotherValueTakesThePlaceOfWhatSaysTheSame() {
    MotionDiagnosis late = DIAGNOSER.with(SILENT, LATE, 0.05);
    MotionDiagnosis wheels = DIAGNOSER.with(late, WHEELS, 1.1);
    assertEquals(List.of(LATE, WHEELS), forms(wheels));
    MotionDiagnosis scale = DIAGNOSER.with(wheels, SCALE, 1.2);
    assertEquals(List.of(LATE, SCALE), forms(scale));
    MotionDiagnosis again = DIAGNOSER.with(scale, SCALE, 1.3);
    assertEquals(List.of(LATE, SCALE), forms(again));
    assertEquals(List.of(0.05, 1.3), Arrays.stream(values(again)).boxed().toList());
    assertEquals(0.13, again.forecast().chain().speed(0.1, 0), 1e-12);
    assertEquals(0.05, again.forecast().chain().delayS(), 1e-12);
    assertEquals(late.headline(), again.headline());
    // Another form of the effect.
    MotionDiagnosis growing =
        SILENT.with(List.of(new FittedMotion(GROWING, new double[] {1.1, 0.1})), SILENT.forecast());
    assertEquals(List.of(SCALE), forms(DIAGNOSER.with(growing, SCALE, 1.2)));
    assertEquals(1.2, DIAGNOSER.estimate(growing, SCALE).value(), 0.01);
  }

  /** A robot that stands shows no scale: it says nothing of it, however it is fitted. */
  @Test
  void whatCannotShowHasNoEstimate() {
    Drives drives = new Drives(67);
    drives.seconds = 12;
    drives.deadSpeed = 9;
    drives.deadTurn = 9;
    MotionData data = drives.data();
    MotionDiagnoser diagnoser = new MotionDiagnoser(data);
    FittedMotion dead = new FittedMotion(form("dead-band"), new double[] {1, 3});
    MotionDiagnosis silent = diagnoser.diagnose();
    MotionDiagnosis stands = silent.with(List.of(dead), silent.forecast());
    Estimate none = diagnoser.estimate(stands, SCALE);

    assertEquals(1, none.value(), 0);
    // What is allowed is 0.2 to 5.
    assertTrue(none.deviation() > 1e4);
  }
}
