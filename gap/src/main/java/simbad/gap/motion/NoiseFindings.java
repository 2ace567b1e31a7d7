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

  /** Of what only happens now and then, so much may be something else than a slip. */
  private static final double OTHER_SHARE = 0.25;

  /** Of events of either sign half would be short; of slips nearly all are. */
  private static final double PER_SLIP_NATS = Math.log(0.95 / 0.5);

  private static final double PER_OTHER_NATS = Math.log(0.05 / 0.5);

  private final Evidence evidence;
  private final Noise[] believed;
  private final Fit fit;
  private final Events events;

  NoiseFindings(Evidence evidence, Noise[] believed, Fit fit) {
    this.evidence = evidence;
    this.believed = believed;
    this.fit = fit;
    events = Events.of(evidence, fit);
  }

  List<MotionFinding> all() {
    List<MotionFinding> all = new ArrayList<>();
    slip().ifPresent(all::add);
    noise().ifPresent(all::add);
    return all;
  }

  /** Tells how probable it is that something happens now and then that is no slip. */
  double otherEvents() {
    double often = OTHER_SHARE * events.shorter();
    return events.other() < LEAST_SLIPS ? 0 : Chance.ofLogOdds(events.other() - often - 2);
  }

  private Optional<MotionFinding> slip() {
    double nats =
        events.shorter() * PER_SLIP_NATS + events.other() * PER_OTHER_NATS - Odds.COST_NATS / 2;
    if (events.shorter() < LEAST_SLIPS || nats <= 0) {
      return Optional.empty();
    }
    double seconds = 0;
    for (int i = 0; i < evidence.size(); i++) {
      seconds += evidence.step(i).durationS();
    }
    double rate = 60 * events.shorter() / seconds;
    double half = Chance.NORMAL_95 * rate / Math.sqrt(events.shorter());
    return Optional.of(
        finding(
            MotionForms.SLIP,
            Chance.ofLogOdds(nats),
            parameter("slips_per_minute", rate, half),
            "let wheels slip %.2g times a minute"));
  }

  private Optional<MotionFinding> noise() {
    Noise along = fit.noises()[0];
    Noise turn = fit.noises()[2];
    double times = Math.max(times(along, believed[0]), times(turn, believed[2]));
    double nats = -Odds.COST_NATS;
    for (int c = 0; c < believed.length; c++) {
      double own = new Whitening(evidence, fit.noises()[c], fit.residuals()[c]).logDensity();
      nats += own - new Whitening(evidence, believed[c], fit.residuals()[c]).logDensity();
    }
    if (times < MATTERS || nats <= 0 || believed[0].tracker() <= Noise.LEAST) {
      return Optional.empty();
    }
    double sigma = Math.sqrt(along.variance(OVER_S));
    double half = Chance.NORMAL_95 * sigma / Math.sqrt(2.0 * evidence.blockCount());
    return Optional.of(
        finding(
            MotionForms.MOTION_NOISE,
            Chance.ofLogOdds(nats),
            parameter("along_sigma_m", sigma, half),
            "let the way of half a second scatter by %.2g m"));
  }

  private static double times(Noise noise, Noise believed) {
    return Math.sqrt(noise.variance(OVER_S) / believed.variance(OVER_S));
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
