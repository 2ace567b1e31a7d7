package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/** Robots that are told three speeds and two turns, as most programs tell them. */
class FewSpeedsTest {
  private static final String STEPS = "command-quantization";

  private static MotionDiagnosis diagnosed(Consumer<Drives> world) {
    Drives drives = new Drives(71);
    drives.askedStep = 0.1;
    drives.askedTurns = new double[] {-0.5, 0.4};
    world.accept(drives);
    return new MotionDiagnoser(drives.data()).diagnose();
  }

  private static Set<String> names(MotionDiagnosis diagnosis) {
    return diagnosis.findings().stream()
        .map(MotionFinding::effect)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  private static void scaled(Drives drives) {
    drives.speedFactor = 0.95;
    drives.turnFactor = 0.96;
  }

  private static void scaledAndLagging(Drives drives) {
    scaled(drives);
    drives.lagS = 0.2;
  }

  private static void atOneSpeed(Drives drives) {
    drives.oneSpeed = true;
    drives.speedFactor = 0.93;
    drives.turnFactor = 0.96;
    drives.lagS = 0.2;
  }

  private static void wheels(Drives drives) {
    drives.speedFactor = 0.95;
    drives.turnFactor = 0.95;
  }

  private static void inSteps(Drives drives) {
    drives.speedStep = 0.08;
    drives.turnStep = 0.3;
  }

  static Stream<Arguments> robots() {
    return Stream.of(
        Arguments.of((Consumer<Drives>) drives -> {}, Set.of()),
        Arguments.of((Consumer<Drives>) FewSpeedsTest::scaled, Set.of("speed-scale", "turn-scale")),
        Arguments.of(
            (Consumer<Drives>) FewSpeedsTest::scaledAndLagging,
            Set.of("actuation-lag", "speed-scale", "turn-scale")),
        Arguments.of(
            (Consumer<Drives>) FewSpeedsTest::atOneSpeed,
            Set.of("actuation-lag", "speed-scale", "turn-scale")),
        Arguments.of((Consumer<Drives>) FewSpeedsTest::wheels, Set.of("wheel-scale")),
        Arguments.of((Consumer<Drives>) FewSpeedsTest::inSteps, Set.of(STEPS)));
  }

  /** Steps of 47.5 mm/s and 0.096 rad/s would do to these commands what two scales do. */
  @ParameterizedTest
  @MethodSource("robots")
  void plainCauses_areNamed(Consumer<Drives> world, Set<String> named) {
    MotionDiagnosis diagnosis = diagnosed(world);
    assertEquals(named, names(diagnosis), diagnosis::headline);
    assertEquals(named.isEmpty() ? Verdict.NONE : Verdict.EXPLAINED, diagnosis.verdict());
  }

  /** What the log cannot tell from a scale is said with it. */
  @Test
  void whatActsAsAFactor_isATie() {
    MotionDiagnosis diagnosis = diagnosed(FewSpeedsTest::scaledAndLagging);
    assertTrue(
        diagnosis.findings().stream().anyMatch(one -> one.ties().contains(STEPS)),
        () -> diagnosis.findings().toString());
  }

  /** Steps and a bias do here nearly what two scales and a bias do. */
  @Test
  void whatIsNearlyFactors_isNeverSure() {
    MotionDiagnosis diagnosis =
        diagnosed(
            drives -> {
              scaledAndLagging(drives);
              drives.turnBias = 0.02;
            });
    assertFalse(
        diagnosis.verdict() == Verdict.EXPLAINED && names(diagnosis).contains(STEPS),
        diagnosis::headline);
  }

  private static MotionHypothesis set(String name, double... values) {
    MotionForm form = MotionForms.find(name).orElseThrow();
    return new MotionHypothesis(MotionChain.EXACT, List.of(form), values);
  }

  /** Costs worked out by hand: 6 an effect, 6 for a second factor, 2 for each that is not plain. */
  @Test
  void costs_areThoseOfFactors() {
    List<Command> commands =
        List.of(
            new Command(0, 0.1, 0.4),
            new Command(1, 0.2, -0.4),
            new Command(2, 0.3, 0),
            new Command(3, 0, 0));
    PlainFactors factors = new PlainFactors(List.of(new MotionRun("a", commands, List.of())));
    MotionHypothesis both = set(STEPS, 0.0475, 0.096);
    MotionHypothesis speeds = set(STEPS, 0.0475, 0);
    MotionHypothesis other = set(STEPS, 0.08, 0.096);
    MotionHypothesis scale = set("speed-scale", 0.95);

    assertEquals(6 + 6 + 4, factors.costNats(both), 1e-12);
    assertEquals(6 + 2, factors.costNats(speeds), 1e-12);
    assertEquals(6 + 2, factors.costNats(other), 1e-12);
    assertEquals(6, factors.costNats(scale), 1e-12);
    assertFalse(factors.isPlain(both) || factors.isPlain(speeds));
    assertTrue(factors.isPlain(other) && factors.isPlain(scale));
    assertEquals(MotionForms.SCALES, factors.scales(both.changes().get(0)));
    assertEquals(MotionForms.SCALES.subList(0, 1), factors.scales(speeds.changes().get(0)));
    assertEquals(List.of(), factors.scales(scale.changes().get(0)));
  }
}
