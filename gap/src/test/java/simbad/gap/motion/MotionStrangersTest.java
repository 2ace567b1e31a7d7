package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.gap.motion.MotionStrangers.Kind;
import simbad.gap.motion.MotionStrangers.Trace;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.forecast.MotionForecast;

/** Traces of patterns that are laid over an exact drive: what foretells one explains it whole. */
class MotionStrangersTest {
  private static final MotionHypothesis NONE =
      new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
  private static final MotionForm SCALE = MotionForms.find("speed-scale").orElseThrow();
  private static final List<MotionRun> RUNS = runs();
  private static final MotionSteps GIVEN = new MotionSteps(RUNS);
  private static final double[][] TOLD = GIVEN.expected(MotionChain.EXACT);
  private static final int ALONG = 0;
  private static final int TURN = 2;

  /** Scatter in which no pattern is far out, so that all steps count alike. */
  private static final Noise[] NOISES = {
    new Noise(Drives.SIGMA_M, 0.01, Noise.GAUSSIAN),
    new Noise(Drives.SIGMA_M, 0.01, Noise.GAUSSIAN),
    new Noise(Drives.SIGMA_RAD, 0.05, Noise.GAUSSIAN)
  };

  /**
   * By so much a step goes too far, as 60 degrees of freedom say less of a mean than of weights.
   */
  private static final double STEP = 63 / 61.0;

  private static List<MotionRun> runs() {
    Drives drives = new Drives(81);
    drives.backwards = true;
    return drives.data().runs();
  }

  /** A pattern by step. */
  private interface Pattern {
    double at(int step);
  }

  private static double[][] patterned(int component, Pattern pattern) {
    double[][] residuals = GIVEN.residuals(MotionChain.EXACT);
    for (int i = 0; i < GIVEN.size(); i++) {
      residuals[component][i] += pattern.at(i);
    }
    return residuals;
  }

  private static ScoredMotion scored(MotionHypothesis set, double[][] residuals) {
    return ScoredMotion.of(GIVEN, new MotionFit(set, residuals, NOISES, 0));
  }

  private static MotionStrangers strangers(ScoredMotion best) {
    return strangers(GIVEN, best);
  }

  /** Of an explanation of a log that is otherwise as it is believed. */
  static MotionStrangers strangers(MotionSteps given, ScoredMotion best) {
    List<MotionRun> runs = given.runs();
    Odds odds = new Odds(List.of(best));
    List<MotionChain> folds = Collections.nCopies(MotionSteps.FOLDS, MotionChain.EXACT);
    MotionForecast nominal = MotionGap.forecast(runs, MotionChain.EXACT);
    BelievedMotion base =
        new BelievedMotion(nominal, best.fit().noises(), List.of(), Optional.empty());
    MotionGap gap = MotionGap.of(runs, nominal, folds);
    NoiseFindings scatter = new NoiseFindings(given, base, best.fit());
    return new MotionStrangers(new Told(given, runs, odds, gap, scatter), best);
  }

  private static List<Trace> traces(double[][] residuals) {
    return strangers(scored(NONE, residuals)).traces(residuals);
  }

  private static Trace of(Kind kind, List<Trace> traces) {
    return traces.stream().filter(trace -> trace.kind() == kind).findFirst().orElseThrow();
  }

  private static double square(double[] values) {
    return Arrays.stream(values).map(v -> v * v).sum();
  }

  /** How much of all that is left over in a component a pattern is. */
  private static double share(int component, Pattern pattern, double[][] residuals) {
    double own = 0;
    for (int i = 0; i < GIVEN.size(); i++) {
      own += pattern.at(i) * pattern.at(i);
    }
    return STEP * STEP * own / square(residuals[component]);
  }

  private static TrackPose pose(int step) {
    return GIVEN.step(step).from();
  }

  private static Arguments pattern(Kind kind, int component, Pattern pattern) {
    return Arguments.of(kind, component, pattern);
  }

  static Stream<Arguments> patterns() {
    return Stream.of(
        pattern(Kind.TIME, ALONG, i -> 0.1 * pose(i).timeS() / 60 * TOLD[ALONG][i]),
        pattern(Kind.TIME, TURN, i -> 0.1 * pose(i).timeS() / 60 * TOLD[TURN][i]),
        pattern(Kind.HEADING, ALONG, i -> 0.1 * TOLD[ALONG][i] * Math.cos(pose(i).headingRad())),
        pattern(Kind.HEADING, TURN, i -> 0.1 * TOLD[TURN][i] * Math.sin(2 * pose(i).headingRad())),
        pattern(Kind.SIDE, TURN, i -> 0.1 * Math.abs(TOLD[TURN][i])),
        pattern(Kind.SIDE, ALONG, i -> 0.1 * Math.abs(TOLD[ALONG][i])),
        pattern(Kind.SIZE, TURN, i -> 0.5 * TOLD[TURN][i] * Math.abs(TOLD[TURN][i])),
        pattern(Kind.SIZE, ALONG, i -> 0.5 * TOLD[ALONG][i] * Math.abs(TOLD[TURN][i])),
        pattern(Kind.PLACE, TURN, i -> 0.1 * TOLD[TURN][i] * pose(i).xM()),
        pattern(Kind.PLACE, ALONG, i -> 0.1 * TOLD[ALONG][i] * pose(i).yM()),
        pattern(
            Kind.RESPONSE,
            ALONG,
            i ->
                0.02
                    * CommandTrail.held(RUNS.get(0).commands(), GIVEN.step(i).to().timeS() - 0.8)
                        .speedMPerS()));
  }

  @ParameterizedTest(name = "{0} in {1}")
  @MethodSource("patterns")
  void aPatternIsFoundByItsKind_andExplainedWhole(Kind kind, int component, Pattern pattern) {
    double[][] residuals = patterned(component, pattern);
    List<Trace> traces = traces(residuals);
    Trace own = of(kind, traces);

    assertTrue(MotionUnknown.gain(own) > 10, own::toString);
    assertEquals(share(component, pattern, residuals), own.share(), 0.06);
    Trace likeliest =
        traces.stream().max(Comparator.comparingDouble(MotionUnknown::gain)).orElseThrow();
    assertEquals(kind, likeliest.kind());
  }

  /** Each of the 750 steps is the tracker's noise alone. */
  @Test
  void anExactDriveHasNoTrace() {
    List<Trace> traces = traces(GIVEN.residuals(MotionChain.EXACT));

    assertTrue(traces.stream().allMatch(t -> MotionUnknown.gain(t) < 0), traces::toString);
    List<Kind> kinds = traces.stream().map(Trace::kind).sorted().toList();
    List<Kind> all = new ArrayList<>(List.of(Kind.values()));
    // Its scatter is looked at elsewhere.
    all.remove(Kind.SCATTER);
    assertEquals(all, kinds);
  }

  /** By how many values a trace could gain something by chance; a ripple is the best of many. */
  @Test
  void aTraceSaysHowManyValuesItHas() {
    List<Trace> traces = traces(GIVEN.residuals(MotionChain.EXACT));

    assertEquals(5, of(Kind.TIME, traces).values());
    assertEquals(14, of(Kind.HEADING, traces).values());
    assertEquals(5, of(Kind.SIZE, traces).values());
    assertEquals(4, of(Kind.SIDE, traces).values());
    assertEquals(12, of(Kind.PLACE, traces).values());
    assertEquals(12, of(Kind.RESPONSE, traces).values());
    assertEquals(2 + 16, of(Kind.RIPPLE, traces).values());
    assertEquals(1, of(Kind.LOST, traces).values());
    assertEquals(4, of(Kind.LATE, traces).values());
    // Four values that may differ in each of seven parts of fifteen blocks.
    assertEquals(4 * 6, of(Kind.DRIFT, traces).values());
  }

  /** What is left out is foretold by the explanation's own values and those of the trace. */
  @Test
  void heldOutIsThatOfBothTogether() {
    Drives drives = new Drives(83);
    drives.speedFactor = 1.2;
    drives.oneSided = 0.1;
    MotionSteps given = new MotionSteps(drives.data().runs());
    MotionHypothesis set = NONE.with(SCALE, new double[] {1.19});
    double[][] residuals = given.residuals(set.chain());
    ScoredMotion best = ScoredMotion.of(given, new MotionFit(set, residuals, NOISES, 0));
    double heldOut = strangers(given, best).heldOut(Kind.SIDE);
    double[][] told = given.expected(set.chain());
    double[][][] columns = {
      best.slopes().columns()[0],
      white(best, ALONG, i -> Math.abs(told[ALONG][i])),
      white(best, ALONG, i -> Math.abs(told[TURN][i])),
      white(best, TURN, i -> Math.abs(told[TURN][i])),
      white(best, TURN, i -> Math.abs(told[ALONG][i]))
    };
    Linear linear = new Linear(given, best.slopes().white(), columns);

    assertEquals(Arrays.stream(linear.heldOut()).sum(), heldOut, 1e-6);
    assertTrue(heldOut > best.heldOut() + 10, heldOut + " and " + best.heldOut());
  }

  private static double[][] white(ScoredMotion best, int component, Pattern pattern) {
    Whitening[] filters = best.slopes().white();
    double[][] column = new double[3][filters[0].white.length];
    Arrays.setAll(column[component], pattern::at);
    double[][] white = new double[3][];
    Arrays.setAll(white, c -> filters[c].of(column[c]));
    return white;
  }

  /** With the noise as it was a trace gains no more than it does, and by clumping less. */
  @Test
  void aTraceGainsWhatItForetellsOfLeftOutBlocks() {
    double[][] residuals = patterned(TURN, i -> 0.1 * Math.abs(TOLD[TURN][i]));
    ScoredMotion best = scored(NONE, residuals);
    MotionStrangers strangers = strangers(best);
    for (Trace trace : strangers.traces(residuals)) {
      if (trace.kind() == Kind.SIDE || trace.kind() == Kind.TIME) {
        double plain = strangers.heldOut(trace.kind()) - best.heldOut();
        assertTrue(trace.raw() >= plain - 1e-6, trace::toString);
        assertTrue(Math.abs(trace.nats()) <= Math.abs(trace.raw()) + 1e-9, trace::toString);
      }
    }
  }

  /** The greatest share of the three components; of a component that is exact there is none. */
  @Test
  void aShareIsThatOfTheComponentWhereItIsMost() {
    double[][] all = {{3, 4}, {0, 0}, {6, 8}};
    double[][] part = {{3, 0}, {7, 7}, {0, 2}};

    assertEquals(9 / 25.0, MotionStrangers.share(part, all), 1e-12);
    assertEquals(0, MotionStrangers.share(part, new double[3][2]), 0);
  }
}
