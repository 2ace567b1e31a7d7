package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.forecast.MotionForecast;

/** What only scatters, of residuals that are said step by step. */
class NoiseFindingsTest {
  private static final double EXACT = 1e-9;
  private static final int ALONG = 0;
  private static final int TURN = 2;
  private static final Noise[] BELIEVED = {
    Noise.believed(0.001), Noise.believed(0.001), Noise.believed(0.002)
  };

  /** What scatters itself, and a tracker as it is believed. */
  private static final Noise[] FOUND = {
    new Noise(0.001, 0.02, 60), BELIEVED[1], new Noise(0.002, 0.1, 60)
  };

  /** White residuals are residuals over one and the same scale. */
  private static final Noise[] PLAIN = {
    new Noise(1e-5, 0.02, 60), new Noise(1e-5, 0.02, 60), new Noise(1e-5, 0.02, 60)
  };

  /** Every four seconds the speed changes, the turn never. */
  private static List<Command> speeds(int count) {
    List<Command> commands = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      commands.add(new Command(4 * i, 0.2 + 0.1 * (i % 2), 0.5));
    }
    return commands;
  }

  private static MotionSteps given(List<Command> commands, int steps) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= steps; i++) {
      track.add(new TrackPose(i / 5.0, 0, 0, 0));
    }
    return new MotionSteps(List.of(new MotionRun("a", commands, track)));
  }

  private static BelievedMotion base(Noise[] noises, Optional<MotionSteps> reference) {
    return new BelievedMotion(
        MotionForecast.believed(Robot.EXACT_UNICYCLE),
        noises,
        List.of(),
        reference.map(steps -> new BelievedMotion.Reference(steps, 1)));
  }

  private static NoiseFindings findings(
      MotionSteps given, double[][] residuals, Noise[] noises, MotionForm... forms) {
    MotionHypothesis set = new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
    for (MotionForm form : forms) {
      set = set.with(form, form.neutralValues());
    }
    return new NoiseFindings(
        given, base(BELIEVED, Optional.empty()), new MotionFit(set, residuals, noises, 0));
  }

  /** 400 steps off by one to either side, but for some that are off by so many times that. */
  private static double[][] spikes(int component, double times, int... steps) {
    double[][] residuals = new double[3][400];
    for (int i = 0; i < 400; i++) {
      residuals[ALONG][i] = i % 2 == 0 ? 0.01 : -0.01;
      residuals[TURN][i] = residuals[ALONG][i];
    }
    for (int step : steps) {
      residuals[component][step] = 0.01 * times;
    }
    return residuals;
  }

  /** So many steps, every second command apart, half a command after it has changed. */
  private static int[] calm(int count) {
    int[] steps = new int[count];
    for (int i = 0; i < count; i++) {
      steps[i] = 10 + 40 * i;
    }
    return steps;
  }

  private static NoiseFindings events(double[][] residuals, MotionForm... forms) {
    return findings(given(speeds(20), 400), residuals, PLAIN, forms);
  }

  private static double chance(double logOdds) {
    return 1 / (1 + Math.exp(-logOdds));
  }

  /** Of what is short of the way 95 in 100 are slips' and half are others'; 3 nats are asked. */
  @Test
  void fiveSlipsAreSaid() {
    MotionFinding slip = events(spikes(ALONG, -12, calm(5))).slip().orElseThrow();
    double half = 1.96 * 3.75 / Math.sqrt(5);

    assertEquals(MotionForms.SLIP, slip.effect());
    assertEquals(MotionForms.SLIP, slip.form());
    assertEquals(chance(5 * Math.log(1.9) - 3), slip.probability(), EXACT);
    // In 80 seconds.
    MotionFinding.Parameter rate = slip.parameters().get(0);
    assertEquals("slips_per_minute", rate.name());
    assertEquals(3.75, rate.value(), EXACT);
    assertEquals(3.75 - half, rate.ci95().low(), EXACT);
    assertEquals(3.75 + half, rate.ci95().high(), EXACT);
    assertEquals(new Interval(0, Double.POSITIVE_INFINITY), rate.allowed());
    assertEquals("let wheels slip 3.8 times a minute", slip.remedy());
    assertTrue(events(spikes(ALONG, -12, calm(4))).slip().isEmpty());
  }

  /** Of slips one in twenty would be long. */
  @Test
  void whatIsLongSpeaksAgainstSlips() {
    double[][] one = spikes(ALONG, -12, calm(9));
    one[ALONG][370] = 0.12;
    MotionFinding slip = events(one).slip().orElseThrow();
    assertEquals(chance(9 * Math.log(1.9) + Math.log(0.1) - 3), slip.probability(), EXACT);

    double[][] eight = spikes(ALONG, -12, calm(8));
    eight[ALONG][370] = 0.12;
    assertTrue(events(eight).slip().isEmpty());
    // Just as its command has changed it counts as much.
    double[][] late = spikes(ALONG, -12, calm(8));
    late[ALONG][361] = 0.12;
    assertTrue(events(late).slip().isEmpty());
  }

  @Test
  void slipsAreWhereTheyWere() {
    List<MotionSteps.Stretch> slips = events(spikes(ALONG, -12, 10, 50)).slips();

    assertEquals(2, slips.size());
    assertEquals(2, slips.get(0).fromS(), EXACT);
    assertEquals(3.4, slips.get(0).toS(), EXACT);
    assertEquals(10, slips.get(1).fromS(), EXACT);
  }

  /** Five are asked, and log odds of 2; of slips a quarter may be something else. */
  @Test
  void whatIsLongNowAndThenIsNoSlip() {
    assertEquals(chance(3), events(spikes(ALONG, 12, calm(5))).otherEvents(), EXACT);
    assertEquals(0, events(spikes(ALONG, 12, calm(4))).otherEvents(), 0);
    double[][] both = spikes(ALONG, 12, calm(6));
    for (int i = 0; i < 8; i++) {
      both[ALONG][30 + 40 * i] = -0.12;
    }
    assertEquals(chance(6 - 2 - 2), events(both).otherEvents(), EXACT);
  }

  /** Just as commands have changed: counted only where it is as much as all the rest. */
  @Test
  void unsteadyMomentsAreNoEvents_whereTheyHardlyMatter() {
    int[] changed = {21, 61, 101, 141, 181, 221};
    double[][] small = spikes(ALONG, 9, changed);
    double[][] large = spikes(ALONG, 20, changed);
    MotionForm lag = MotionForms.find("actuation-lag: time constants").orElseThrow();

    assertEquals(0, events(small).otherEvents(), 0);
    assertEquals(chance(4), events(large).otherEvents(), EXACT);
    assertEquals(0, events(large, lag).otherEvents(), 0);
    for (String name : List.of("actuation-latency", "time-offset")) {
      assertEquals(0, events(large, MotionForms.find(name).orElseThrow()).otherEvents(), 0);
    }
    MotionForm scale = MotionForms.find("speed-scale").orElseThrow();
    assertEquals(chance(4), events(large, scale).otherEvents(), EXACT);
    // Only the speed's command has changed: of turns it is something else.
    assertEquals(chance(4), events(spikes(TURN, 9, changed)).otherEvents(), EXACT);
  }

  private static double[][] scattered(MotionSteps given, double way, double turn) {
    SplittableRandom random = new SplittableRandom(17);
    double[][] residuals = new double[3][given.size()];
    for (int i = 0; i < given.size(); i++) {
      double root = Math.sqrt(given.loads()[i] * 0.2);
      residuals[0][i] = way * root * random.nextGaussian() + 0.001 * random.nextGaussian();
      residuals[1][i] = 0.001 * random.nextGaussian();
      residuals[2][i] = turn * root * random.nextGaussian() + 0.002 * random.nextGaussian();
    }
    return residuals;
  }

  private static double nats(MotionSteps given, double[][] residuals) {
    return Whitening.logDensity(given, FOUND, residuals)
        - Whitening.logDensity(given, BELIEVED, residuals)
        - 6;
  }

  @Test
  void moreScatterThanBelievedIsSaid_withItsSize() {
    MotionSteps given = given(speeds(20), 400);
    double[][] residuals = scattered(given, 0.02, 0.1);
    NoiseFindings findings = findings(given, residuals, FOUND);
    MotionFinding noise = findings.noise().orElseThrow();
    double sigma = Math.sqrt(2e-6 + 60 / 58.0 * 0.0004 * 0.5);
    double half = 1.96 * sigma / Math.sqrt(2.0 * 8);

    assertEquals(MotionForms.MOTION_NOISE, noise.effect());
    assertEquals(chance(nats(given, residuals)), noise.probability(), 1e-5);
    MotionFinding.Parameter along = noise.parameters().get(0);
    assertEquals("along_sigma_m", along.name());
    assertEquals(sigma, along.value(), EXACT);
    assertEquals(sigma - half, along.ci95().low(), EXACT);
    assertEquals(sigma + half, along.ci95().high(), EXACT);
    assertEquals("let the distance driven in half a second scatter by 0.014 m", noise.remedy());
    assertTrue(findings.oneSided().isEmpty());
    assertTrue(findings.slip().isEmpty());
  }

  /** Steps of which so few say so little that it counts: 20 half seconds are three steps each. */
  @Test
  void aLogMustHaveTwentyHalfSeconds() {
    MotionSteps enough = given(speeds(4), 60);
    double[][] residuals = scattered(enough, 0.02, 0.1);
    assertTrue(nats(enough, residuals) > 0);
    assertTrue(findings(enough, residuals, FOUND).noise().isPresent());

    MotionSteps few = given(speeds(4), 59);
    assertTrue(nats(few, scattered(few, 0.02, 0.1)) > 0);
    assertTrue(findings(few, scattered(few, 0.02, 0.1), FOUND).noise().isEmpty());
  }

  @Test
  void scatterThatIsBelievedIsNone() {
    MotionSteps given = given(speeds(20), 400);

    assertTrue(findings(given, scattered(given, 0, 0), FOUND).noise().isEmpty());
    // More would matter to nobody.
    assertTrue(findings(given, scattered(given, 0.02, 0.1), BELIEVED).noise().isEmpty());
    // Of a tracker whose noise is not known nothing is more.
    Noise[] unknown = {Noise.believed(0), BELIEVED[1], BELIEVED[2]};
    MotionHypothesis none = new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
    MotionFit fit = new MotionFit(none, scattered(given, 0.02, 0.1), FOUND, 0);
    assertTrue(new NoiseFindings(given, base(unknown, Optional.empty()), fit).noise().isEmpty());
  }

  /** The way scatters and the turns, which would be seen, do not. */
  @Test
  void oneSidedScatterIsATraceAndNoNoise() {
    MotionSteps given = given(speeds(20), 400);
    double[][] residuals = scattered(given, 0.02, 0);
    Noise[] way = {FOUND[0], BELIEVED[1], BELIEVED[2]};
    NoiseFindings findings = findings(given, residuals, way);
    MotionStrangers.Trace trace = findings.oneSided().orElseThrow();
    MotionHypothesis none = new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
    double share =
        Scatter.of(given, new MotionFit(none, residuals, way, 0), BELIEVED).along() / 0.02;

    assertTrue(findings.noise().isEmpty());
    assertTrue(findings.isOfTheWay());
    assertEquals(MotionStrangers.Kind.SCATTER, trace.kind());
    double nats =
        Whitening.logDensity(given, way, residuals)
            - Whitening.logDensity(given, BELIEVED, residuals)
            - 6;
    assertEquals(nats, trace.nats(), 1e-6);
    assertEquals(0.015 * share, trace.share(), EXACT);
    Noise[] turns = {BELIEVED[0], BELIEVED[1], FOUND[2]};
    assertFalse(findings(given, scattered(given, 0, 0.1), turns).isOfTheWay());
  }

  /** A reference that scatters in the way as this log does: nothing is more than usual. */
  @Test
  void whatTheReferenceScattersByIsUsual() {
    MotionSteps given = given(speeds(20), 400);
    Noise[] way = {FOUND[0], BELIEVED[1], BELIEVED[2]};
    MotionHypothesis none = new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
    MotionFit fit = new MotionFit(none, scattered(given, 0.02, 0), way, 0);

    assertTrue(
        new NoiseFindings(given, base(BELIEVED, Optional.of(rough(0.02))), fit)
            .oneSided()
            .isEmpty());
    assertTrue(
        new NoiseFindings(given, base(BELIEVED, Optional.of(rough(0.0))), fit)
            .oneSided()
            .isPresent());
  }

  /** Straight on at 20 cm/s, by a way that scatters. */
  private static MotionSteps rough(double process) {
    SplittableRandom random = new SplittableRandom(18);
    List<TrackPose> track = new ArrayList<>();
    double x = 0;
    for (int i = 0; i <= 400; i++) {
      track.add(new TrackPose(i / 5.0, x + 0.001 * random.nextGaussian(), 0, 0));
      x += 0.04 + process * Math.sqrt(0.2) * random.nextGaussian();
    }
    return new MotionSteps(List.of(new MotionRun("r", List.of(new Command(0, 0.2, 0)), track)));
  }

  /** Commands at every step, some of which change much and some hardly. */
  private static List<Command> lively() {
    SplittableRandom random = new SplittableRandom(19);
    List<Command> commands = new ArrayList<>();
    for (int i = 0; i < 200; i++) {
      double much = i % 4 == 0 ? 0.2 : 0.02;
      double off = random.nextDouble(-1, 1);
      commands.add(new Command(0.4 * i, 0.25 + much * off, 0.8 + 3 * much * off));
    }
    return commands;
  }

  /** What scatters as commands change comes at unsteady moments: that is no noise of motion. */
  @Test
  void scatterOfChangesIsNone() {
    MotionSteps given = given(lively(), 400);
    double[][] moving = scattered(given, 0.04, 0.2);
    double[][] changing = new double[3][400];
    SplittableRandom random = new SplittableRandom(20);
    for (int c : new int[] {ALONG, TURN}) {
      double[] changes = given.changes(c, 0);
      for (int i = 0; i < 400; i++) {
        double process = c == ALONG ? 0.04 : 0.2;
        changing[c][i] = process * Math.sqrt(0.2 * changes[i]) * random.nextGaussian();
      }
    }

    assertTrue(findings(given, moving, FOUND).noise().isPresent());
    assertTrue(nats(given, changing) > 0);
    assertTrue(findings(given, changing, FOUND).noise().isEmpty());
  }
}
