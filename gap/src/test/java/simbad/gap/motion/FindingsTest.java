package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.gap.score.IntervalWidths;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.effect.MotionParameter;

/** What sets say of each name, weighed by figures that are set by hand. */
class FindingsTest {
  private static final double WIDE = 1.96 * IntervalWidths.own().motion();

  private static final double EXACT = 1e-9;
  private static final MotionForm LATE = form("actuation-latency");
  private static final MotionForm SCALE = form("speed-scale");
  private static final MotionForm GROWING = form("speed-scale: growing with the speed");
  private static final MotionForm TURN_GROWING = form("turn-scale: growing with the turn rate");
  private static final MotionForm SOFT = form("saturation: soft");
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
  private static final MotionSteps GIVEN = new MotionSteps(runs());
  private static final Noise[] NOISES = {
    Noise.believed(0.002), Noise.believed(0.002), Noise.believed(0.005)
  };

  /** Its chance: how likely the one set is beside the others. */
  private static final double NATS = 40;

  private static MotionForm form(String name) {
    return MotionForms.find(name).orElseThrow();
  }

  private static List<MotionRun> runs() {
    Drives drives = new Drives(71);
    drives.seconds = 40;
    return drives.data().runs();
  }

  /** A set whose left-out blocks are said; what its values do is as it is. */
  private static ScoredMotion set(MotionHypothesis hypothesis, double nats) {
    MotionFit fit = new MotionFit(hypothesis, GIVEN.residuals(hypothesis.chain()), NOISES, nats);
    double[] blocks = new double[GIVEN.blockCount()];
    Arrays.fill(blocks, nats / blocks.length);
    return new ScoredMotion(fit, new Slopes(GIVEN, fit), blocks);
  }

  private static ScoredMotion one(MotionForm form, double nats, double... values) {
    return set(NONE.with(form, values), nats);
  }

  private static MotionFinding named(MotionForm form, double... values) {
    List<MotionFinding> named =
        new Findings(new Odds(List.of(set(NONE, 0), one(form, NATS, values)))).named();
    assertEquals(1, named.size());
    return named.get(0);
  }

  @Test
  void aNameComesWithItsValuesAndItsRemedy() {
    MotionFinding found = named(LATE, 0.25);
    double error = one(LATE, NATS, 0.25).slopes().standardErrors()[0];
    MotionParameter latency = LATE.parameters().get(0);

    assertEquals("actuation-latency", found.effect());
    assertEquals("actuation-latency", found.form());
    assertEquals("delay commands by 0.2500 s", found.remedy());
    // 40 nats less 6, over 1.5.
    assertEquals(1 / (1 + Math.exp(-34 / 1.5)), found.probability(), EXACT);
    MotionFinding.Parameter value = found.parameters().get(0);
    assertEquals("latency_s", value.name());
    assertEquals(0.25, value.value(), 0);
    assertTrue(error > 0 && error < 0.1, () -> "error " + error);
    assertEquals(0.25 - WIDE * error, value.ci95().low(), EXACT);
    assertEquals(0.25 + WIDE * error, value.ci95().high(), EXACT);
    assertEquals(new Interval(latency.low(), latency.high()), value.allowed());
    assertFalse(value.atBound());
  }

  @Test
  void noIntervalGoesBeyondWhatIsAllowed() {
    MotionFinding.Parameter most = named(LATE, 2).parameters().get(0);
    assertEquals(2, most.ci95().high(), 0);
    assertTrue(most.ci95().low() < 2 && most.atBound());
    assertEquals(0, named(LATE, 1e-9).parameters().get(0).ci95().low(), 0);
  }

  /** Motion jumps as a step of commands changes: blocks say nothing of how exactly it is known. */
  @Test
  void noIntervalIsSaidOfWhatMotionJumpsWith() {
    MotionForm steps = MotionForms.find("command-quantization").orElseThrow();
    MotionHypothesis stepped = NONE.with(steps, new double[] {0.1, 0.2});
    ScoredMotion set = set(stepped, NATS);
    MotionFinding found = new Findings(new Odds(List.of(set(NONE, 0), set))).named().get(0);
    for (MotionFinding.Parameter each : found.parameters()) {
      assertEquals(new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY), each.ci95());
    }
    assertEquals(2, found.parameters().size());
  }

  /** Each value has the error that stands in its own place. */
  @Test
  void theSecondFormsValuesComeAfterTheFirstOnes() {
    MotionHypothesis both =
        NONE.with(GROWING, new double[] {1.01, 0.03}).with(LATE, new double[] {0.02});
    ScoredMotion set = set(both, NATS);
    double[] errors = set.slopes().standardErrors();
    List<MotionFinding> named = new Findings(new Odds(List.of(set(NONE, 0), set))).named();
    MotionFinding late =
        named.stream().filter(f -> f.effect().equals(LATE.effect())).findFirst().orElseThrow();
    MotionFinding speed =
        named.stream().filter(f -> f.effect().equals("speed-scale")).findFirst().orElseThrow();

    assertEquals(2, named.size());
    assertEquals(1, late.parameters().size());
    assertEquals(0.02, late.parameters().get(0).value(), 0);
    assertEquals(WIDE * errors[2], half(late.parameters().get(0)), EXACT);
    assertEquals(
        List.of("speed_factor", "speed_factor_per_m_s"),
        speed.parameters().stream().map(MotionFinding.Parameter::name).toList());
    assertEquals(1.01, speed.parameters().get(0).value(), 0);
    assertEquals(0.03, speed.parameters().get(1).value(), 0);
    assertEquals(WIDE * errors[0], half(speed.parameters().get(0)), EXACT);
    assertEquals(WIDE * errors[1], half(speed.parameters().get(1)), EXACT);
  }

  /** To the side on which no bound is near. */
  private static double half(MotionFinding.Parameter value) {
    return value.ci95().high() - value.value();
  }

  /** The sentence of a form is about its first value, and no sentence is about what stays. */
  @Test
  void aRemedyIsAboutTheFirstValueThatChanges() {
    assertEquals(
        "multiply commanded speeds by 1.500 before driving the model", named(SCALE, 1.5).remedy());
    assertEquals("give the model speed_factor_per_m_s = -0.5000", named(GROWING, 1, -0.5).remedy());
    assertEquals("", named(GROWING, 1, 0).remedy());
  }

  @Test
  void twoFormsOfOneEffectAreOneFinding() {
    MotionHypothesis both =
        NONE.with(SCALE, new double[] {1.5}).with(GROWING, new double[] {1, 0.25});
    List<MotionFinding> named =
        new Findings(new Odds(List.of(set(NONE, 0), set(both, NATS)))).named();

    assertEquals(1, named.size());
    assertEquals("speed-scale + speed-scale: growing with the speed", named.get(0).form());
    assertEquals(
        "multiply commanded speeds by 1.500 before driving the model; "
            + "give the model speed_factor_per_m_s = 0.2500",
        named.get(0).remedy());
    assertEquals(3, named.get(0).parameters().size());
  }

  /** A limit that is infinite is none. */
  @Test
  void whatIsInfiniteIsNoValue() {
    MotionFinding found = named(SOFT, 0.125, Double.POSITIVE_INFINITY, 0.25);

    assertEquals(
        List.of("max_speed_m_s", "softness"),
        found.parameters().stream().map(MotionFinding.Parameter::name).toList());
    assertEquals("bend speeds towards a limit of 0.1250 m/s", found.remedy());
  }

  /** The turn's scale is nearly as likely alone as beside the latency. */
  private static Odds torn() {
    MotionHypothesis late = NONE.with(LATE, new double[] {0.25});
    return new Odds(
        List.of(
            set(NONE, 0),
            set(late.with(TURN_GROWING, new double[] {1.25, 0}), NATS),
            one(TURN_GROWING, NATS - 7.5, 1.25, 0),
            one(LATE, NATS - 40, 0.25),
            one(SCALE, NATS - 9, 1.5),
            set(NONE.with(SCALE, new double[] {1.25}).with(LATE, new double[] {0.125}), 1)));
  }

  @Test
  void theSurestNameComesFirst() {
    List<MotionFinding> named = new Findings(torn()).named();

    assertEquals(
        List.of("turn-scale", "actuation-latency"),
        named.stream().map(MotionFinding::effect).toList());
    assertTrue(named.get(0).probability() > named.get(1).probability());
  }

  @Test
  void othersAreWhatMightBe_theLikeliestFirst() {
    Findings findings = new Findings(torn());
    List<MotionFinding> named = findings.named();
    List<MotionFinding> others = findings.others(named);
    MotionFinding scale = others.get(0);

    assertEquals(MotionForms.vocabulary().size() - 2, others.size());
    assertEquals("speed-scale", scale.effect());
    assertEquals("speed-scale", scale.form());
    assertEquals("", scale.remedy());
    // Of the sets that have it the likelier one says how much.
    assertEquals(1.5, scale.parameters().get(0).value(), 0);
    assertTrue(scale.probability() > 0);
    for (MotionFinding none : others.subList(1, others.size())) {
      assertEquals(new MotionFinding(none.effect(), "", 0, List.of(), List.of(), ""), none);
      assertTrue(named.stream().noneMatch(one -> one.effect().equals(none.effect())));
    }
  }

  @Test
  void whoIsTiedWithANameHasItAsATie() {
    List<MotionFinding> named =
        List.of(
            new MotionFinding("a", "", 0.9, List.of(), List.of("speed-scale"), ""),
            new MotionFinding("b", "", 0.9, List.of(), List.of("turn-bias"), ""),
            new MotionFinding("c", "", 0.9, List.of(), List.of("slip", "speed-scale"), ""));
    MotionFinding scale =
        new Findings(torn())
            .others(named).stream()
                .filter(one -> one.effect().equals("speed-scale"))
                .findFirst()
                .orElseThrow();

    assertEquals(List.of("a", "c"), scale.ties());
  }

  /** What stands in the place of the one name is nearly as likely. */
  @Test
  void aNamesTiesAreThoseOfTheSets() {
    Odds odds = new Odds(List.of(set(NONE, 0), one(LATE, NATS, 0.25), one(SCALE, NATS - 1, 1.5)));

    assertEquals(List.of("speed-scale"), new Findings(odds).named().get(0).ties());
  }
}
