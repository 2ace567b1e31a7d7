package simbad.gap.motion;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * How probable it is that something without a name is at work.
 *
 * @param traces what plain regressions foretell of what is left over
 * @param events how probable it is that something happens now and then that is no slip
 */
record MotionUnknown(List<MotionStrangers.Trace> traces, double events) {
  /** What a trace must gain on left-out blocks to be as probable as its absence. */
  private static final double COST_NATS = 8;

  /** What each of its values gains by chance. */
  private static final double PER_VALUE_NATS = 0.5;

  /** A trace that foretells less of what the nominal model leaves over matters to nobody. */
  private static final double SHARE = 0.015;

  /** Fitted with {@link #SHARE} on 600 practice worlds of SRB-1 (seeds 781 and 782). */
  private static final double TEMPERATURE = 2.5;

  private static final double LIKELY = 0.5;

  /**
   * Returns the trace of scatter that no unsteady motor makes.
   *
   * @param nats by which it is likelier
   * @param times by how many times it is larger than what matters
   */
  static MotionStrangers.Trace scatter(double nats, double times) {
    return new MotionStrangers.Trace(MotionStrangers.Kind.SCATTER, 0, nats, 0, SHARE * times);
  }

  private static double logOdds(MotionStrangers.Trace trace) {
    double small = COST_NATS * (trace.share() / SHARE - 1);
    return Math.min(gain(trace), small) / TEMPERATURE;
  }

  /** Returns by how many nats a trace gains more than by chance. */
  static double gain(MotionStrangers.Trace trace) {
    return trace.nats() - COST_NATS - PER_VALUE_NATS * trace.values();
  }

  private static double probability(MotionStrangers.Trace trace) {
    return NormalChance.ofLogOdds(logOdds(trace));
  }

  double probability() {
    return Math.max(
        events, traces.stream().mapToDouble(MotionUnknown::probability).max().orElse(0));
  }

  /** Returns the same without one kind of trace, which a name accounts for. */
  MotionUnknown without(MotionStrangers.Kind kind) {
    return new MotionUnknown(
        traces.stream().filter(trace -> trace.kind() != kind).toList(), events);
  }

  /** Tells whether something comes again as a wheel turns, however little that foretells. */
  boolean isRipple() {
    return traces.stream().anyMatch(t -> t.kind() == MotionStrangers.Kind.RIPPLE && gain(t) > 0);
  }

  boolean isLikely() {
    return probability() > LIKELY;
  }

  /** Returns the trace that it shows by, if it is no event: a likely trace says more than those. */
  Optional<MotionStrangers.Trace> trace() {
    return traces.stream()
        .max(Comparator.comparingDouble(MotionUnknown::logOdds))
        .filter(trace -> probability(trace) >= Math.min(events, LIKELY));
  }

  /** Says what it looks like. */
  String words() {
    return trace()
        .map(trace -> trace.kind().words())
        .orElse("now and then it is far off, in either direction");
  }
}
