package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simbad.gap.diagnosis.Interval;
import simbad.motion.effect.MotionForms;

/** Effects that change how motion scatters and not where it leads. */
final class NoiseFindings {
  /** Half a second: the shortest horizon of the gap. */
  private static final double OVER_S = 0.5;

  /** Scatter that is larger by less matters to nobody. */
  private static final double MATTERS = 1.25;

  private static final int LEAST_SLIPS = 5;

  /** What is far off is then as much as all the rest together. */
  private static final double HEAVY = 2;

  /** Names of what makes commands act late. */
  private static final List<String> TIMING =
      List.of("actuation-latency", "actuation-lag", "time-offset");

  /** A robot that is asked for less, of the mean, is taken to stand. */
  private static final double MOVING = 0.25;

  private static final int FEWEST = 20;

  /** Of what only happens now and then, so much may be something else than a slip. */
  private static final double OTHER_SHARE = 0.25;

  /** Of events of either sign half would be short; of slips nearly all are. */
  private static final double PER_SLIP_NATS = Math.log(0.95 / 0.5);

  private static final double PER_OTHER_NATS = Math.log(0.05 / 0.5);

  private final MotionSteps given;
  private final BelievedMotion base;
  private final Noise[] believed;
  private final MotionFit fit;
  private final Events events;
  private final Scatter scatter;

  NoiseFindings(MotionSteps given, BelievedMotion base, MotionFit fit) {
    this.given = given;
    this.base = base;
    believed = base.noises();
    this.fit = fit;
    events = Events.of(given, fit);
    scatter = Scatter.of(given, fit, believed);
  }

  /**
   * Tells how probable it is that something happens now and then that is no slip. What is off just
   * as commands have changed comes at unsteady moments where commands are known to act late, or
   * where it hardly matters; else it is off.
   */
  double otherEvents() {
    boolean unsteady =
        events.heavy() < HEAVY || TIMING.stream().anyMatch(name -> fit.hypothesis().names(name));
    int other = events.other() + (unsteady ? 0 : events.late());
    double often = OTHER_SHARE * events.shorter();
    return other < LEAST_SLIPS ? 0 : NormalChance.ofLogOdds(other - often - 2);
  }

  /** Returns when wheels slipped. */
  List<MotionSteps.Stretch> slips() {
    return events.slips();
  }

  /** Wheels that slip now and then. */
  Optional<MotionFinding> slip() {
    double nats =
        events.shorter() * PER_SLIP_NATS
            + (events.late() + events.other()) * PER_OTHER_NATS
            - Odds.COST_NATS / 2;
    if (events.shorter() < LEAST_SLIPS || nats <= 0) {
      return Optional.empty();
    }
    double seconds = 0;
    for (int i = 0; i < given.size(); i++) {
      seconds += given.step(i).durationS();
    }
    double rate = 60 * events.shorter() / seconds;
    double half = NormalChance.NORMAL_95 * rate / Math.sqrt(events.shorter());
    return Optional.of(
        finding(
            MotionForms.SLIP,
            NormalChance.ofLogOdds(nats),
            parameter("slips_per_minute", rate, half),
            "let wheels slip %.2g times a minute"));
  }

  /**
   * Scatter shows wherever the robot moves. What is off now and then, or where commands have just
   * changed, leaves the median of half seconds as it was.
   */
  Optional<MotionFinding> noise() {
    double nats = more();
    if (nats <= 0 || scatter.isOneSided()) {
      return Optional.empty();
    }
    double sigma = Math.sqrt(fit.noises()[0].variance(OVER_S, 1));
    double half = NormalChance.NORMAL_95 * sigma / Math.sqrt(2.0 * given.blockCount());
    return Optional.of(
        finding(
            MotionForms.MOTION_NOISE,
            NormalChance.ofLogOdds(nats),
            parameter("along_sigma_m", sigma, half),
            "let the distance driven in half a second scatter by %.2g m"));
  }

  /**
   * Returns the trace of a cause without a name that shows as scatter of the way alone or of the
   * turns alone.
   */
  Optional<MotionStrangers.Trace> oneSided() {
    double nats = more();
    return nats > 0 && scatter.isOneSided()
        ? Optional.of(MotionUnknown.scatter(nats, scatter.greatest() / Scatter.MATTERS))
        : Optional.empty();
  }

  /** By how many nats more scatter than believed is likelier; 0 where it does not matter. */
  private double more() {
    double times =
        Math.max(scattersAsItMoves(0) ? times(0) : 0, scattersAsItMoves(2) ? times(2) : 0);
    if (times < MATTERS || believed[0].tracker() <= Noise.LEAST || !scatter.matters()) {
      return 0;
    }
    double nats = -Odds.COST_NATS;
    for (int c = 0; c < believed.length; c++) {
      double own = new Whitening(given, fit.noises()[c], fit.residuals()[c]).logDensity();
      nats += own - new Whitening(given, believed[c], fit.residuals()[c]).logDensity();
    }
    return Math.max(0, nats);
  }

  /** Tells whether the way scatters more than the turns, as of a wheel that is not round. */
  boolean isOfTheWay() {
    return scatter.along() > scatter.turn();
  }

  /** Tells whether scatter goes with motion itself rather than with changes of the command. */
  private boolean scattersAsItMoves(int component) {
    double[] residuals = fit.residuals()[component];
    double delayS = fit.hypothesis().chain().delayS();
    return NoiseFit.likeliest(given, given.loads(), residuals)
        >= NoiseFit.likeliest(given, given.changes(component, delayS), residuals);
  }

  /**
   * By how many times half seconds of moving are farther off than believed, by their median, over
   * the same of the reference: no law of scatter is quite right.
   */
  private double times(int component) {
    double own = times(given, fit.residuals()[component], believed[component]);
    return own / Math.max(1, base.reference().map(one -> usual(one, component)).orElse(1.0));
  }

  private double usual(BelievedMotion.Reference reference, int component) {
    MotionSteps trusted = reference.given();
    double[] residuals = trusted.residuals(base.nominal().chain())[component];
    return times(trusted, residuals, believed[component]);
  }

  private static double times(MotionSteps given, double[] residuals, Noise believed) {
    List<Double> sizes = new ArrayList<>();
    double sum = 0;
    double seconds = 0;
    double load = 0;
    for (int i = 0; i < given.size(); i++) {
      MotionSteps.Step step = given.step(i);
      if (!step.chained()) {
        sum = 0;
        seconds = 0;
        load = 0;
      }
      sum += residuals[i];
      seconds += step.durationS();
      load += step.load() * step.durationS();
      if (seconds >= OVER_S - 1e-6) {
        double mean = load / seconds;
        if (mean > MOVING) {
          sizes.add(Math.abs(sum) / Math.sqrt(believed.variance(seconds, mean)));
        }
        sum = 0;
        seconds = 0;
        load = 0;
      }
    }
    double[] sorted = sizes.stream().mapToDouble(size -> size).sorted().toArray();
    return sorted.length < FEWEST ? 0 : sorted[sorted.length / 2] / NormalChance.MEDIAN;
  }

  private static MotionFinding.Parameter parameter(String name, double value, double half) {
    Interval allowed = new Interval(0, Double.POSITIVE_INFINITY);
    Interval ci95 = new Interval(Math.max(0, value - half), value + half);
    return new MotionFinding.Parameter(name, value, ci95, allowed, false);
  }

  private static MotionFinding finding(
      String effect, double sure, MotionFinding.Parameter parameter, String remedy) {
    String said = String.format(Locale.ROOT, remedy, parameter.value());
    return new MotionFinding(effect, effect, sure, List.of(parameter), List.of(), said);
  }
}
