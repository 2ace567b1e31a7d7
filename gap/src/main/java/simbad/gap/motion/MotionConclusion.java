package simbad.gap.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToDoubleFunction;
import simbad.gap.diagnosis.Verdict;

/**
 * Which names are said, and how surely.
 *
 * @param named effects of the most probable set that are confirmed, and what scatters
 * @param noises that only scatter, said or not, and what is too unsure to stand beside a stranger
 * @param shadows effects of the most probable set that something without a name may account for
 * @param unknown something without a name
 * @param sure whether all that is named is sure
 * @param gap that the most probable set leaves
 * @param floor that scatter alone leaves
 */
record MotionConclusion(
    List<MotionFinding> named,
    List<MotionFinding> noises,
    List<String> shadows,
    MotionUnknown unknown,
    boolean sure,
    double gap,
    double floor) {
  /** An effect that is less probable, its ties counted, is not concluded. */
  private static final double SURE = 0.8;

  /** An effect that the vocabulary fits only nearly leaves scatter beside it. */
  private static final double SURE_BESIDE = 0.9;

  /** What may be the shadow of something without a name is no likelier than not. */
  private static final double EVEN = 0.5;

  /**
   * A gap of so many floors is no chance. Of 60 practice worlds (seed 785) no right none has more
   * than 1.7, of 60 others (seed 786) one has 1.87.
   */
  private static final double LEFT = 2;

  /** Names that a wheel out of round goes by. */
  private static final Set<String> WHEELS = Set.of("wheel-scale", "wheel-asymmetry", "speed-scale");

  /**
   * Concludes.
   *
   * @param told by the log
   * @param slip that was found before slips were left out
   */
  static MotionConclusion of(Told told, Optional<MotionFinding> slip) {
    Odds odds = told.odds();
    List<MotionFinding> found = new Findings(odds).named();
    MotionStrangers strangers = new MotionStrangers(told, odds.best());
    List<MotionStrangers.Trace> traces =
        new ArrayList<>(strangers.traces(odds.nominal().fit().residuals()));
    if (slip.isEmpty()) {
      told.scatter().oneSided().ifPresent(traces::add);
    }
    // Where all motion scatters, some of it does so far.
    double events = noise(told).isPresent() ? 0 : told.scatter().otherEvents();
    MotionUnknown all = new MotionUnknown(traces, events);
    // A wheel whose size is named may well be out of round.
    boolean wheels = found.stream().anyMatch(one -> WHEELS.contains(one.effect()));
    MotionUnknown unknown = wheels ? all.without(MotionStrangers.Kind.RIPPLE) : all;
    if (wheels && told.scatter().isOfTheWay()) {
      unknown = unknown.without(MotionStrangers.Kind.SCATTER);
    }
    List<MotionFinding> named = new ArrayList<>();
    List<String> shadows = new ArrayList<>();
    double beside =
        unknown.isLikely() ? unknown.trace().map(t -> strangers.heldOut(t.kind())).orElse(0.0) : 0;
    for (MotionFinding one : found) {
      if (isConfirmed(one, told, beside, unknown)) {
        named.add(one);
      } else {
        shadows.add(one.effect());
      }
    }
    boolean sure = named.stream().allMatch(one -> odds.ofAny(one.effect(), one.ties()) >= SURE);
    List<MotionFinding> noises = noises(told, slip, !unknown.isLikely() && !all.isRipple());
    // Beside names, scatter that is not sure is only said to be possible.
    boolean alone = named.isEmpty();
    noises.stream().filter(one -> alone || one.probability() >= SURE_BESIDE).forEach(named::add);
    sure &= !alone || noises.stream().allMatch(one -> one.probability() >= SURE);
    double floor = told.gap().floor(odds.best().fit().noises());
    return new MotionConclusion(named, noises, shadows, unknown, sure, told.gap().ratio(), floor);
  }

  /**
   * Tells whether an effect is needed also where something without a name may be anything, and
   * matters more than that: what gains less may be its shadow.
   *
   * @param beside log density of left-out blocks with all effects and what has no name
   */
  private static boolean isConfirmed(
      MotionFinding one, Told told, double beside, MotionUnknown unknown) {
    if (!unknown.isLikely() || unknown.trace().isEmpty()) {
      return true;
    }
    MotionStrangers.Trace trace = unknown.trace().get();
    Odds odds = told.odds();
    MotionStrangers without = new MotionStrangers(told, odds.lacking(one.effect()));
    double nats = beside - without.heldOut(trace.kind());
    return nats > trace.raw() && odds.ofGain(nats) >= SURE;
  }

  /**
   * What changes the scatter alone. What has no name scatters as well, and a wheel out of round.
   */
  private static List<MotionFinding> noises(
      Told told, Optional<MotionFinding> slip, boolean nothingElse) {
    List<MotionFinding> noises = new ArrayList<>();
    slip.ifPresent(noises::add);
    if (nothingElse) {
      noise(told).ifPresent(noises::add);
    }
    return noises;
  }

  /** Scatter alone is said only where it makes a gap. */
  private static Optional<MotionFinding> noise(Told told) {
    boolean named = !told.odds().best().hypothesis().forms().isEmpty();
    return named || told.gap().ratio() <= MotionDiagnoser.WORTH
        ? told.scatter().noise()
        : Optional.empty();
  }

  /**
   * Returns what stays of a partly that says no name which is less probable than any other name.
   *
   * @param rightly how often such a name is at work, by counting
   * @param weights how probable a name is, its ties counted, among the sets
   */
  MotionConclusion doubting(
      ToDoubleFunction<MotionFinding> rightly, ToDoubleFunction<MotionFinding> weights) {
    if (verdict() != Verdict.PARTLY) {
      return this;
    }
    List<MotionFinding> kept = new ArrayList<>();
    List<MotionFinding> weighed = new ArrayList<>(noises);
    for (MotionFinding one : named) {
      double weight =
          noises.contains(one) ? one.probability() : Math.min(1, weights.applyAsDouble(one));
      double share = rightly.applyAsDouble(one);
      if (share * weight >= SURE) {
        kept.add(one);
      } else {
        weighed.remove(one);
        weighed.add(one.times(share));
      }
    }
    // Without something that has no name, what is too unsure is all that there is to say.
    return unknown.isLikely()
        ? new MotionConclusion(kept, weighed, shadows, unknown, sure, gap, floor)
        : new MotionConclusion(
            named, noises, shadows, unknown, kept.size() == named.size(), gap, floor);
  }

  /** Tells whether a gap is left, of a robot that is believed, that scatter does not make. */
  private boolean isLeft() {
    return LEFT * floor < 1;
  }

  private boolean shrinks() {
    return gap < 1;
  }

  /** Tells whether what is believed foretells as well as what was found. */
  boolean isAsBelieved() {
    return !shrinks() || (named.isEmpty() && !unknown.isLikely());
  }

  Verdict verdict() {
    boolean atBound =
        named.stream()
            .flatMap(finding -> finding.parameters().stream())
            .anyMatch(MotionFinding.Parameter::atBound);
    boolean idle = sure && !shrinks();
    if (named.isEmpty() || (idle && unknown.isLikely())) {
      return unknown.isLikely() ? Verdict.UNEXPLAINED : isLeft() ? Verdict.UNDECIDED : Verdict.NONE;
    }
    if (!sure || idle) {
      return Verdict.UNDECIDED;
    }
    return unknown.isLikely() || atBound ? Verdict.PARTLY : Verdict.EXPLAINED;
  }

  /** Returns what is concluded to be at work. */
  List<MotionFinding> explanation() {
    return verdict().namesEffects() ? named : List.of();
  }

  /**
   * Returns what else might be, the likeliest first.
   *
   * @param others every name that is not concluded, as it was weighed
   * @param rightly how often such a name is at work, by counting
   */
  List<MotionFinding> others(List<MotionFinding> others, ToDoubleFunction<MotionFinding> rightly) {
    List<MotionFinding> changed = new ArrayList<>();
    for (MotionFinding one : others) {
      Optional<MotionFinding> noise =
          noises.stream().filter(other -> other.effect().equals(one.effect())).findFirst();
      boolean isShadow = shadows.contains(one.effect());
      MotionFinding own = isShadow ? one.times(rightly.applyAsDouble(one)).atMost(EVEN) : one;
      changed.add(noise.orElse(own));
    }
    changed.sort((a, b) -> Double.compare(b.probability(), a.probability()));
    return changed;
  }

  /**
   * Returns one line.
   *
   * @param shrink of the gap, a share
   */
  String headline(double shrink) {
    String names = String.join(" + ", named.stream().map(MotionFinding::effect).toList());
    String shrinks = String.format(Locale.ROOT, "the gap shrinks by %.0f %%", 100 * shrink);
    return switch (verdict()) {
      case NONE -> "no gap beyond chance";
      case UNEXPLAINED -> "something that no named effect accounts for: " + unknown.words();
      case UNDECIDED -> undecided(names);
      case PARTLY ->
          names
              + ", and something else ("
              + (unknown.isLikely() ? unknown.words() : "a value is at its bound")
              + "); "
              + shrinks;
      case EXPLAINED -> names + "; " + shrinks;
    };
  }

  private String undecided(String names) {
    if (named.isEmpty()) {
      return String.format(
          Locale.ROOT,
          "the gap is %.1f times what scatter alone leaves, and no effect takes it away",
          1 / floor);
    }
    return sure
        ? String.format(
            Locale.ROOT,
            "%s may be at work, but the gap does not shrink by it: it grows by %.1f %%",
            names,
            100 * (gap - 1))
        : "this log cannot tell which effects are at work; the most likely: " + names;
  }
}
