package simbad.gap.score;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import simbad.sonar.check.Checks;

/**
 * How probable each of some sets of effects is, whatever the log is of, and each effect.
 *
 * @param <E> an effect
 */
public final class Weights<E extends Comparable<? super E>> {
  private final List<Set<E>> sets;
  private final double[] logs;
  private final double[] shares;
  private final int best;

  /**
   * Weighs sets.
   *
   * @param sets at least one, in any order
   * @param logs how likely each is, natural logarithms up to a constant
   */
  public Weights(List<Set<E>> sets, double[] logs) {
    this.sets = List.copyOf(sets);
    this.logs = Checks.numbers("logs", logs).clone();
    int first = 0;
    for (int i = 1; i < logs.length; i++) {
      first = logs[i] > logs[first] ? i : first;
    }
    best = first;
    shares = new double[logs.length];
    double sum = 0;
    for (int i = 0; i < logs.length; i++) {
      shares[i] = Math.exp(-behind(i));
      sum += shares[i];
    }
    for (int i = 0; i < logs.length; i++) {
      shares[i] /= sum;
    }
  }

  /** Returns which set is the most probable one; of equal ones the first. */
  public int best() {
    return best;
  }

  /** Returns by how many natural logarithms a set is behind the most probable one. */
  public double behind(int set) {
    return logs[best] - logs[set];
  }

  /** Returns how probable it is that one of the sets is right that are like this. */
  public double of(Predicate<Set<E>> like) {
    double sum = 0;
    for (int i = 0; i < shares.length; i++) {
      sum += like.test(sets.get(i)) ? shares[i] : 0;
    }
    return sum;
  }

  /**
   * Returns how probable it is that each effect is at work that is in any set.
   *
   * @param alike what is as probable as an effect, in no set, and has an equal share of it
   */
  public Map<E, Double> ofEffects(Function<E, Set<E>> alike) {
    Map<E, Double> sums = new TreeMap<>();
    for (int i = 0; i < shares.length; i++) {
      for (E effect : sets.get(i)) {
        Set<E> twins = alike.apply(effect);
        double share = shares[i] / (1 + twins.size());
        sums.merge(effect, share, Double::sum);
        twins.forEach(twin -> sums.merge(twin, share, Double::sum));
      }
    }
    return sums;
  }

  /**
   * Returns the sets in which something else stands in the place of an effect: they have all else
   * of a set and more, but not the effect.
   *
   * @param effect of the set
   * @param set effects
   */
  public IntStream without(E effect, Set<E> set) {
    Set<E> rest = new TreeSet<>(set);
    rest.remove(effect);
    return IntStream.range(0, logs.length)
        .filter(i -> !sets.get(i).contains(effect))
        .filter(i -> sets.get(i).containsAll(rest) && sets.get(i).size() > rest.size());
  }

  /** Returns what a set has that another has not, in the order of effects. */
  public Set<E> beyond(int set, Set<E> other) {
    Set<E> more = new TreeSet<>(sets.get(set));
    more.removeAll(other);
    return more;
  }
}
