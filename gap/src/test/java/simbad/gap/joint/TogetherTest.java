package simbad.gap.joint;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Estimate;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.motion.Robot;
import simbad.motion.forecast.MotionForecast;

/** Two halves of a joint log, and what is concluded of both. */
class TogetherTest {
  private static final Estimate LARGER = new Estimate(1.05, 0.001);

  private static Diagnosis sensing(Verdict verdict, Effect... named) {
    return SensingHalf.of(verdict, 0.2, List.of(named), Hypothesis.NONE);
  }

  private static MotionDiagnosis motion(int windows, Verdict verdict, String... named) {
    double[][] none = {};
    return new MotionDiagnosis(
        verdict,
        "the track says so",
        List.of(named).stream()
            .map(name -> new MotionFinding(name, name, 0.9, List.of(), List.of(), ""))
            .toList(),
        List.of(),
        0.5,
        Map.of(),
        new MotionDiagnosis.Gap(
            windows, none, none, none, 1, new Interval(0, 1), new Interval(0, 1), 0),
        List.of(),
        List.of(),
        List.of(),
        Optional.empty(),
        List.of(),
        MotionForecast.believed(Robot.EXACT_UNICYCLE));
  }

  private static MotionDiagnosis motion(Verdict verdict, String... named) {
    return motion(100, verdict, named);
  }

  private static MotionDiagnosis silent() {
    return motion(0, Verdict.UNDECIDED);
  }

  private static Shared wheels(boolean tracked, boolean heard, boolean one) {
    return new Shared(
        "wheel-scale", Effect.ODOMETRY_SCALE, "factor", tracked, heard, LARGER, LARGER, one);
  }

  private static JointDiagnosis heard(
      List<Shared> shared, Diagnosis sensing, MotionDiagnosis motion) {
    return new Together(shared, sensing, motion, true).diagnosis();
  }

  private static Verdict verdict(Diagnosis sensing, MotionDiagnosis motion) {
    return heard(List.of(), sensing, motion).verdict();
  }

  /** A cause of both halves is named once, by the name that it has in motion. */
  @Test
  void names_areOfCauses_eachOnce() {
    Diagnosis sensing = sensing(Verdict.EXPLAINED, Effect.ODOMETRY_SCALE, Effect.DROPOUT);
    MotionDiagnosis motion = motion(Verdict.EXPLAINED, "slip", "wheel-scale");
    assertEquals(
        List.of("wheel-scale", "slip", "dropout"),
        heard(List.of(wheels(true, true, true)), sensing, motion).explanation());
    assertEquals(
        List.of("slip", "wheel-scale", "odometry-scale", "dropout"),
        heard(List.of(wheels(true, true, false)), sensing, motion).explanation(),
        "of two values they are two causes");
    assertEquals(
        List.of("wheel-scale", "slip", "odometry-scale", "dropout"),
        heard(List.of(wheels(true, false, true)), sensing, motion).explanation(),
        "what is not heard of the cause is another one");
  }

  @Test
  void readingsThatNameNothing_addNoName() {
    MotionDiagnosis motion = motion(Verdict.NONE);
    for (Verdict verdict : List.of(Verdict.NONE, Verdict.UNEXPLAINED, Verdict.UNDECIDED)) {
      assertEquals(
          List.of(), heard(List.of(), sensing(verdict, Effect.DROPOUT), motion).explanation());
    }
    assertEquals(
        List.of("dropout"),
        heard(List.of(), sensing(Verdict.PARTLY, Effect.DROPOUT), motion).explanation());
  }

  @Test
  void verdict_isTheGraverOfTwo() {
    Diagnosis named = sensing(Verdict.EXPLAINED, Effect.DROPOUT);
    assertEquals(Verdict.NONE, verdict(sensing(Verdict.NONE), motion(Verdict.NONE)));
    assertEquals(Verdict.EXPLAINED, verdict(named, motion(Verdict.NONE)));
    assertEquals(
        Verdict.EXPLAINED, verdict(sensing(Verdict.NONE), motion(Verdict.EXPLAINED, "slip")));
    assertEquals(Verdict.UNDECIDED, verdict(named, motion(Verdict.UNDECIDED)));
    assertEquals(Verdict.UNDECIDED, verdict(sensing(Verdict.UNDECIDED), motion(Verdict.NONE)));
    assertEquals(
        Verdict.UNEXPLAINED, verdict(sensing(Verdict.UNEXPLAINED), motion(Verdict.UNDECIDED)));
    assertEquals(
        Verdict.PARTLY, verdict(sensing(Verdict.UNEXPLAINED), motion(Verdict.EXPLAINED, "slip")));
    assertEquals(Verdict.PARTLY, verdict(named, motion(Verdict.UNEXPLAINED)));
    assertEquals(
        Verdict.PARTLY,
        verdict(sensing(Verdict.NONE), motion(Verdict.PARTLY, "slip")),
        "what one half leaves is left of both");
  }

  @Test
  void halfThatIsTooShort_saysNothing() {
    Diagnosis unexplained = sensing(Verdict.UNEXPLAINED);
    JointDiagnosis short1 =
        new Together(List.of(), unexplained, motion(Verdict.NONE), false).diagnosis();
    assertEquals(Verdict.NONE, short1.verdict());
    assertEquals(0.5, short1.unknownProbability(), 1e-12);
    JointDiagnosis untracked = heard(List.of(), sensing(Verdict.NONE), silent());
    assertEquals(Verdict.NONE, untracked.verdict());
    assertEquals(0.2, untracked.unknownProbability(), 1e-12);
    JointDiagnosis both = new Together(List.of(), unexplained, silent(), false).diagnosis();
    assertEquals(Verdict.UNDECIDED, both.verdict());
    assertEquals(0, both.unknownProbability(), 1e-12);
  }

  /** Something unknown is in neither half with probability 0.8 * 0.5. */
  @Test
  void unknown_isInEitherHalf() {
    JointDiagnosis both = heard(List.of(), sensing(Verdict.NONE), motion(Verdict.NONE));
    assertEquals(0.6, both.unknownProbability(), 1e-12);
  }

  @Test
  void whatReadingsAreNotSureOf_isSure_whereTheTrackShowsTheSame() {
    Diagnosis unsure = sensing(Verdict.UNDECIDED, Effect.ODOMETRY_SCALE);
    MotionDiagnosis motion = motion(Verdict.EXPLAINED, "wheel-scale");
    assertEquals(
        Verdict.EXPLAINED, heard(List.of(wheels(true, true, true)), unsure, motion).verdict());
    assertEquals(
        Verdict.UNDECIDED,
        heard(List.of(wheels(false, true, true)), unsure, motion).verdict(),
        "the track does not show it");
    assertEquals(
        Verdict.UNDECIDED,
        heard(List.of(wheels(true, true, false)), unsure, motion).verdict(),
        "of another value");
    assertEquals(
        Verdict.UNDECIDED,
        heard(
                List.of(wheels(true, true, true)),
                sensing(Verdict.UNDECIDED, Effect.ODOMETRY_SCALE, Effect.DROPOUT),
                motion)
            .verdict(),
        "nobody confirms the other effect");
    assertEquals(
        Verdict.UNDECIDED,
        heard(List.of(wheels(true, true, true)), sensing(Verdict.UNDECIDED), motion).verdict(),
        "there is nothing to confirm");
  }

  @Test
  void reason_saysAllThreeThings() {
    Diagnosis undecided = sensing(Verdict.NONE).undecided("too few rows");
    Shared shared = wheels(true, true, true);
    assertEquals(
        shared.words() + "; motion: the track says so; readings: undecided, too few rows",
        heard(List.of(shared), undecided, motion(Verdict.NONE)).reason());
    assertEquals(
        "motion: the track says so; readings: none",
        heard(List.of(), sensing(Verdict.NONE), motion(Verdict.NONE)).reason());
  }

  @Test
  void halves_areHandedOn() {
    Diagnosis sensing = sensing(Verdict.NONE);
    MotionDiagnosis motion = motion(Verdict.NONE);
    List<Shared> shared = List.of(wheels(true, true, true));
    JointDiagnosis joint = new Together(shared, sensing, motion, false).diagnosis();
    assertSame(sensing, joint.sensing());
    assertSame(motion, joint.motion());
    assertEquals(shared, joint.shared());
    assertEquals(false, joint.isHeard());
  }
}
