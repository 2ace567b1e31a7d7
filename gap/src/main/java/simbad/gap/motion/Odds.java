package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

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
  private final double[] logs;
  private final double[] weights;
  private final double clumping;

  /** Weighs sets; blocks of the likeliest tell how far steps hang together. */
  Odds(List<ScoredMotion> sets) {
    this.sets = List.copyOf(sets);
    clumping = sets.get(0).slopes().linear().clumping();
    logs = new double[sets.size()];
    weights = new double[sets.size()];
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < logs.length; i++) {
      ScoredMotion set = sets.get(i);
      double cost = COST_NATS * set.hypothesis().effects().size() + NATS_PER_JUMP * set.jumping();
      logs[i] = (set.heldOut() / clumping - cost) / TEMPERATURE;
      most = Math.max(most, logs[i]);
    }
    double sum = 0;
    for (int i = 0; i < logs.length; i++) {
      weights[i] = Math.exp(logs[i] - most);
      sum += weights[i];
    }
    for (int i = 0; i < logs.length; i++) {
      weights[i] /= sum;
    }
  }

  /** Returns the same without the sets that name an effect. */
  Odds without(String effect) {
    return new Odds(sets.stream().filter(set -> !set.hypothesis().names(effect)).toList());
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
    return sets.get(bestIndex());
  }

  private int bestIndex() {
    int best = 0;
    for (int i = 1; i < weights.length; i++) {
      best = weights[i] > weights[best] ? i : best;
    }
    return best;
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
    Map<String, Double> sums = new TreeMap<>();
    for (int i = 0; i < weights.length; i++) {
      for (String effect : sets.get(i).hypothesis().effects()) {
        sums.merge(effect, Math.min(1, weights[i]), Double::sum);
      }
    }
    return sums;
  }

  /** Returns the most probable set that has an effect. */
  ScoredMotion bestWith(String effect) {
    int best = -1;
    for (int i = 0; i < weights.length; i++) {
      boolean has = sets.get(i).hypothesis().names(effect);
      best = has && (best < 0 || logs[i] > logs[best]) ? i : best;
    }
    return best < 0 ? best() : sets.get(best);
  }

  /** Returns the ties of an effect of the most probable set, the best first. */
  List<String> tiesOf(String effect) {
    int best = bestIndex();
    List<Rival> rivals = new ArrayList<>();
    Set<String> rest = sets.get(best).hypothesis().without(effect).effects();
    for (int i = 0; i < logs.length; i++) {
      Set<String> others = sets.get(i).hypothesis().effects();
      if (!others.contains(effect)
          && others.containsAll(rest)
          && others.size() > rest.size()
          && (logs[i] > logs[best] - TIE_NATS || !isClear(sets.get(best), sets.get(i)))) {
        others.removeAll(rest);
        double log = logs[i];
        others.forEach(other -> rivals.add(new Rival(other, log)));
      }
    }
    return rivals.stream()
        .sorted(Comparator.comparingDouble(rival -> -rival.log))
        .map(Rival::effect)
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

  private record Rival(String effect, double log) {}

  /** Returns how probable it is that an effect or one that is tied with it is at work. */
  double ofAny(String effect, List<String> tied) {
    double sum = 0;
    for (int i = 0; i < weights.length; i++) {
      MotionHypothesis set = sets.get(i).hypothesis();
      sum += set.names(effect) || tied.stream().anyMatch(set::names) ? weights[i] : 0;
    }
    return Math.min(1, sum);
  }
}
