package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.effect.MotionForms;

/** Drives of a robot that is simulated in the tests, by code of its own. */
class MotionDiagnoserTest {
  private static MotionDiagnosis diagnose(long seed, Consumer<Drives> world) {
    Drives drives = new Drives(seed);
    world.accept(drives);
    return new MotionDiagnoser(drives.data()).diagnose();
  }

  private static Set<String> names(MotionDiagnosis diagnosis) {
    Set<String> names = new TreeSet<>();
    diagnosis.findings().forEach(finding -> names.add(finding.effect()));
    return names;
  }

  private static Arguments world(long seed, String names, Consumer<Drives> world) {
    return Arguments.of(seed, new TreeSet<>(List.of(names.split(" "))), world);
  }

  /** Each effect at about twice the size that matters, pairs at more. */
  static Stream<Arguments> worlds() {
    return Stream.of(
        world(1, "speed-scale", d -> d.speedFactor = 1.02),
        world(2, "turn-scale", d -> d.turnFactor = 0.98),
        world(3, "wheel-scale", d -> d.speedFactor = d.turnFactor = 0.98),
        world(4, "wheel-asymmetry", d -> d.turnPerMetre = 0.04),
        world(5, "turn-bias", d -> d.turnBias = 0.004),
        world(6, "actuation-latency", d -> d.lateS = 0.04),
        world(7, "actuation-lag", d -> d.lagS = 0.06),
        world(8, "actuation-lag", d -> d.acceleration = 1),
        world(10, "saturation", d -> d.mostSpeed = 0.23),
        world(11, "saturation", d -> d.mostTurn = 0.85),
        world(9, "saturation", MotionDiagnoserTest::slowWhileTurning),
        world(20, "saturation", d -> d.softSpeed = 0.25),
        world(21, "wheel-asymmetry", d -> d.rightWheel = 0.02),
        world(12, "command-quantization", d -> d.speedStep = 0.04),
        world(15, "dead-band", d -> d.lessSpeed = 0.02),
        world(16, "command-quantization", d -> d.cutStep = 0.04),
        world(17, "actuation-latency", MotionDiagnoserTest::lateAtUnsteadyMoments),
        world(18, "wheel-scale", MotionDiagnoserTest::largeAndOutOfRound),
        world(19, "slip wheel-asymmetry", MotionDiagnoserTest::slippingAndVeering),
        world(13, "capture-offset", d -> d.forwardM = 0.01),
        world(14, "capture-offset", d -> d.trackerTurned = 0.02),
        world(54, "motion-noise", d -> d.roughness = 0.01),
        world(55, "slip", d -> d.slips = 6),
        world(31, "actuation-latency speed-scale", MotionDiagnoserTest::lateAndSlow),
        world(32, "actuation-lag turn-bias", MotionDiagnoserTest::laggingAndTurning));
  }

  private static void clogging(Drives drives) {
    drives.seconds = 400;
    drives.clogS = 0.3;
  }

  private static void pushedAside(Drives drives) {
    drives.backwards = true;
    drives.kick = 0.2;
  }

  private static void slowWhileTurning(Drives drives) {
    drives.mostSpeed = 0.3;
    drives.lostPerTurn = 0.15;
  }

  private static void lateAndSlow(Drives drives) {
    drives.lateS = 0.1;
    drives.speedFactor = 0.95;
  }

  /** Steps of 47.5 mm/s would do to these speeds what the scale does. */
  private static void askedInSteps(Drives drives) {
    drives.askedStep = 0.05;
    drives.lateS = 0.2;
    drives.speedFactor = 0.95;
    drives.turnFactor = 1.06;
  }

  private static void lateAtUnsteadyMoments(Drives drives) {
    drives.lateS = 0.1;
    drives.unsteadyS = 0.08;
  }

  private static void largeAndOutOfRound(Drives drives) {
    drives.speedFactor = 1.05;
    drives.turnFactor = 1.05;
    drives.ripple = 0.05;
  }

  private static void slippingAndVeering(Drives drives) {
    drives.slips = 8;
    drives.turnPerMetre = 0.1;
  }

  private static void laggingAndTurning(Drives drives) {
    drives.lagS = 0.15;
    drives.turnBias = 0.01;
  }

  /** No other step takes the place of the scale: it is named, and steps are said beside it. */
  @Test
  void scaleOfSpeedsInSteps_isNamedWithThem() {
    MotionDiagnosis diagnosis = diagnose(33, MotionDiagnoserTest::askedInSteps);

    assertEquals(Set.of("actuation-latency", "speed-scale", "turn-scale"), names(diagnosis));
    diagnosis
        .findings()
        .forEach(
            one ->
                assertTrue(
                    one.probability() > 0.8 || one.ties().contains("command-quantization"),
                    one.toString()));
  }

  @ParameterizedTest(name = "{0} {1}")
  @MethodSource("worlds")
  void whatIsAtWork_isNamed(long seed, Set<String> expected, Consumer<Drives> world) {
    MotionDiagnosis diagnosis = diagnose(seed, world);

    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.headline());
    assertEquals(expected, names(diagnosis));
    // What takes away less than slips leave is right two times of three.
    diagnosis.findings().forEach(one -> assertTrue(one.probability() > 0.6, one.toString()));
    assertTrue(diagnosis.gap().shrink() > 0, diagnosis.headline() + diagnosis.fitted());
    double parts = diagnosis.budget().stream().mapToDouble(MotionDiagnosis.Part::share).sum();
    assertEquals(1, parts, 1e-9);
  }

  @ParameterizedTest
  @ValueSource(longs = {100, 101, 102})
  void exactRobot_hasNoGap(long seed) {
    MotionDiagnosis diagnosis = diagnose(seed, drives -> {});

    assertEquals(Verdict.NONE, diagnosis.verdict(), diagnosis.headline());
    assertEquals(0, diagnosis.gap().shrink());
    assertTrue(diagnosis.places().stream().allMatch(place -> place.qValue() > 0.01));
  }

  /** Something without a name: a slope, a battery that sags, commands that are not followed. */
  static Stream<Arguments> strangers() {
    return Stream.of(
        world(51, "heading", d -> d.slope = 0.1),
        world(52, "time", d -> d.sag = 0.15),
        world(53, "now and then", d -> d.dropped = 0.1),
        world(54, "a command is not carried out", d -> d.dropped = 0.3),
        world(55, "far off", d -> d.clogS = 0.3),
        world(55, "sooner for some seconds", MotionDiagnoserTest::clogging),
        world(56, "scatters", MotionDiagnoserTest::pushedAside),
        world(57, "scatters", d -> d.unsteadyTurns = 0.1),
        world(56, "left differs from right", d -> d.oneSided = 0.05));
  }

  @ParameterizedTest(name = "{0} {1}")
  @MethodSource("strangers")
  void whatHasNoName_isNeverExplained(long seed, Set<String> looks, Consumer<Drives> world) {
    MotionDiagnosis diagnosis = diagnose(seed, world);

    Verdict verdict = diagnosis.verdict();
    assertTrue(verdict == Verdict.UNEXPLAINED || verdict == Verdict.PARTLY, diagnosis.headline());
    assertTrue(diagnosis.unknownProbability() > 0.7);
    looks.forEach(word -> assertTrue(diagnosis.headline().contains(word), diagnosis.headline()));
  }

  /** What a 95 % interval holds, and that it is no wider than the practical size. */
  @Test
  void value_liesInItsInterval() {
    MotionFinding.Parameter late =
        diagnose(6, drives -> drives.lateS = 0.1).findings().get(0).parameters().get(0);

    assertTrue(late.ci95().low() < 0.101 && late.ci95().high() > 0.099, late.toString());
    assertTrue(late.ci95().high() - late.ci95().low() < 0.02, late.toString());
  }

  /** With separate clocks a track that runs behind is one with commands that act late. */
  @Test
  void clocksAndLatency_areTied() {
    MotionDiagnosis diagnosis =
        diagnose(
            15,
            drives -> {
              drives.separateClocks = true;
              drives.clockS = 0.1;
            });

    assertEquals(Verdict.EXPLAINED, diagnosis.verdict(), diagnosis.headline());
    MotionFinding only = diagnosis.findings().get(0);
    Set<String> both = new TreeSet<>(only.ties());
    both.add(only.effect());
    assertEquals(Set.of("actuation-latency", "time-offset"), both);
    assertTrue(diagnosis.next().isEmpty(), "no drive tells these two apart");
  }

  /**
   * All commands are at one speed: a cut and a factor do the same, and a ladder tells them apart.
   */
  @Test
  void cutOrFactor_atOneSpeed_areTied_andADriveSeparatesThem() {
    MotionDiagnosis diagnosis =
        diagnose(
            16,
            drives -> {
              drives.oneSpeed = true;
              drives.speedFactor = 0.9;
            });

    MotionFinding only = diagnosis.findings().get(0);
    Set<String> both = new TreeSet<>(only.ties());
    both.add(only.effect());
    assertTrue(both.contains("saturation") && both.contains("speed-scale"), only.toString());
    assertTrue(diagnosis.next().orElseThrow().expectedLogOdds() > 10);
  }

  @Test
  void everyName_standsInADiagnosis_once() {
    MotionDiagnosis diagnosis = diagnose(6, drives -> drives.lateS = 0.1);
    Set<String> all = names(diagnosis);
    diagnosis.others().forEach(finding -> all.add(finding.effect()));

    assertEquals(new TreeSet<>(MotionForms.vocabulary()), all);
    assertEquals(14, diagnosis.findings().size() + diagnosis.others().size());
  }

  @Test
  void shortLog_isUndecided() {
    MotionDiagnosis diagnosis = diagnose(1, drives -> drives.seconds = 30);

    assertEquals(Verdict.UNDECIDED, diagnosis.verdict());
    assertTrue(diagnosis.headline().contains("stretches of ten seconds"), diagnosis.headline());
  }

  @Test
  void ninetyOfAHundred_lieInTheirForecasts() {
    for (double[] horizon : diagnose(6, drives -> drives.lateS = 0.1).gap().coverage()) {
      for (double share : horizon) {
        assertTrue(share > 0.85 && share < 0.95, "share " + share);
      }
    }
  }
}
