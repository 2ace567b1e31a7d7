package simbad.gap.motion;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simbad.gap.score.Weights;

/** How probable each set of effects is among those that were scored, and each effect. */
final class Odds {
  /** What a further effect must gain on left-out blocks to be as probable as its absence. */
  static final double COST_NATS = 6;

  /** Likelihoods of models that are all a little wrong are taken for less than they say. */
  private static final double TEMPERATURE = 1.5;

  /** What a value that jumps gains by chance, since no fold fits it anew. */
  private static final double NATS_PER_JUMP = 2;

  /** A set that is less probable than another by no more is as good: likelihood ratio 20. */
  private static final double TIE_NATS = 3;

  /** By so many standard errors, from block to block, a clear winner foretells better. */
  private static final double CLEAR = 2;

  private final List<ScoredMotion> sets;
  private final Weights<String> weights;
  private final double clumping;

  /** Weighs sets; blocks of the likeliest tell how far steps hang together. */
  Odds(List<ScoredMotion> sets) {
    this.sets = List.copyOf(sets);
    clumping = sets.get(0).slopes().linear().clumping();
    weights =
        new Weights<>(
            sets.stream().map(set -> set.hypothesis().effects()).toList(),
            sets.stream().mapToDouble(this::log).toArray());
  }

  private double log(ScoredMotion set) {
    double cost = set.costNats() + NATS_PER_JUMP * set.jumping();
    return (set.heldOut() / clumping - cost) / TEMPERATURE;
  }

  /** Returns the same without the sets that name an effect. */
  Odds without(String effect) {
    return new Odds(sets.stream().filter(set -> !set.hypothesis().names(effect)).toList());
  }

  /** Returns the same with more sets; of two with the same effects the likelier one stays. */
  Odds and(List<ScoredMotion> more) {
    Map<Set<String>, ScoredMotion> all = new LinkedHashMap<>();
    Stream.concat(sets.stream(), more.stream())
        .sorted(Comparator.comparingDouble(set -> -set.heldOut()))
        .forEach(set -> all.putIfAbsent(set.hypothesis().effects(), set));
    return new Odds(List.copyOf(all.values()));
  }

  /** Returns the likeliest set that has no effects but those of the most probable one, less one. */
  ScoredMotion lacking(String effect) {
    Set<String> rest = best().hypothesis().without(effect).effects();
    return sets.stream()
        .filter(set -> rest.containsAll(set.hypothesis().effects()))
        .max(Comparator.comparingDouble(ScoredMotion::heldOut))
        .orElseThrow();
  }

  /** Returns how probable it is that an effect is needed, by what blocks gain that are left out. */
  double ofGain(double nats) {
    return NormalChance.ofLogOdds((nats / clumping - COST_NATS) / TEMPERATURE);
  }

  double clumping() {
    return clumping;
  }

  ScoredMotion best() {
    return sets.get(weights.best());
  }

  /** Returns the set without any effect. */
  ScoredMotion nominal() {
    return sets.stream()
        .filter(set -> set.hypothesis().forms().isEmpty())
        .findFirst()
        .orElseThrow();
  }

  /** Returns for each effect that was fitted how probable it is that it is at work. */
  Map<String, Double> ofEffects() {
    return weights.ofEffects(effect -> Set.of());
  }

  /** Returns the most probable set that has an effect. */
  ScoredMotion bestWith(String effect) {
    return IntStream.range(0, sets.size())
        .filter(i -> sets.get(i).hypothesis().names(effect))
        .boxed()
        .min(Comparator.comparingDouble(weights::behind))
        .map(sets::get)
        .orElse(best());
  }

  /** Returns the ties of an effect of the most probable set, the best first. */
  List<String> tiesOf(String effect) {
    Set<String> own = best().hypothesis().effects();
    return weights
        .without(effect, own)
        .filter(i -> weights.behind(i) < TIE_NATS || !isClear(best(), sets.get(i)))
        .boxed()
        .sorted(Comparator.comparingDouble(weights::behind))
        .flatMap(i -> weights.beyond(i, own).stream())
        .distinct()
        .toList();
  }

  /** Tells whether blocks agree that one set foretells better than another. */
  private static boolean isClear(ScoredMotion one, ScoredMotion other) {
    int n = one.blocks().length;
    double mean = (one.heldOut() - other.heldOut()) / n;
    double square = 0;
    for (int b = 0; b < n; b++) {
      double off = one.blocks()[b] - other.blocks()[b] - mean;
      square += off * off;
    }
    return mean > CLEAR * Math.sqrt(square / Math.max(1, n - 1) / n);
  }

  /** Returns how probable it is that an effect or one that is tied with it is at work. */
  double ofAny(String effect, List<String> tied) {
    return Math.min(
        1, weights.of(set -> set.contains(effect) || tied.stream().anyMatch(set::contains)));
  }
}
