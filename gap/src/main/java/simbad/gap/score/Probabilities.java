package simbad.gap.score;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import simbad.definition.Effect;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.HeldOut.Scored;
import simbad.sonar.check.Checks;

/** How probable each set of effects is among those that were fitted, and each effect. */
public final class Probabilities {
  /** What a further effect must gain held-out at least, whatever the number of rows. */
  public static final double COST_NATS = 10;

  /** What does not show in the gap costs so many times more. */
  public static final double UNSEEN = 4;

  /** What a value gains by chance. */
  public static final double NATS_PER_VALUE = 0.5;

  private final List<Scored> sets;
  private final Set<Effect> unseen;
  private final Map<Effect, Set<Effect>> twins;
  private final double[] weight;

  /** By how much each is behind the most probable one, natural logarithms. */
  private final double[] behind;

  /**
   * Weighs sets of effects without twins.
   *
   * @param sets with their held-out scores
   * @param costNats what a further effect must gain to be as probable as its absence
   * @param temperature by which nats are divided
   * @param unseen effects that do not show in the gap
   */
  public Probabilities(List<Scored> sets, double costNats, double temperature, Set<Effect> unseen) {
    this(sets, costNats, temperature, unseen, Map.of());
  }

  /**
   * Weighs sets.
   *
   * @param sets with their held-out scores
   * @param costNats what a further effect must gain to be as probable as its absence
   * @param temperature by which nats are divided: likelihoods of models that are all a little
   *     wrong, of readings that hang together, are taken for less than they say
   * @param unseen effects that do not show in the gap
   * @param twins of an effect: what the log cannot tell from it because of how it was taken, and
   *     what is in none of the sets
   */
  public Probabilities(
      List<Scored> sets,
      double costNats,
      double temperature,
      Set<Effect> unseen,
      Map<Effect, Set<Effect>> twins) {
    Checks.number("costNats", costNats);
    Checks.positive("temperature", temperature);
    this.sets = List.copyOf(sets);
    this.unseen = Set.copyOf(unseen);
    this.twins = Map.copyOf(twins);
    weight = new double[sets.size()];
    behind = new double[sets.size()];
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < weight.length; i++) {
      Scored set = sets.get(i);
      List<Effect> effects = set.hypothesis().effects();
      double shares = shares(effects.size());
      shares += UNSEEN * effects.stream().filter(unseen::contains).count();
      double nats = set.heldOut() - costNats * shares - NATS_PER_VALUE * values(set.hypothesis());
      weight[i] = nats / temperature;
      most = Math.max(most, weight[i]);
    }
    double sum = 0;
    for (int i = 0; i < weight.length; i++) {
      behind[i] = most - weight[i];
      weight[i] = Math.exp(-behind[i]);
      sum += weight[i];
    }
    for (int i = 0; i < weight.length; i++) {
      weight[i] /= sum;
    }
  }

  /**
   * How many times the cost of one effect some effects cost together: three at once are rare, and
   * what needs them is more often one thing that has no name.
   */
  private static double shares(int effects) {
    return effects + 3.0 * Math.max(0, effects - 2) * Math.max(0, effects - 1) / 2;
  }

  /** Of sets that predict alike the one with fewer values is likelier; a table counts as one. */
  private static int values(Hypothesis set) {
    return set.forms().stream().mapToInt(f -> f.isTable() ? 1 : f.parameters().size()).sum();
  }

  /** Returns the most probable set. */
  public Scored best() {
    int best = 0;
    for (int i = 1; i < weight.length; i++) {
      best = weight[i] > weight[best] ? i : best;
    }
    return sets.get(best);
  }

  /**
   * Returns by how many natural logarithms a set's probability is behind the most probable one's;
   * infinity for a set that was left out.
   */
  public double behind(Scored set) {
    int at = sets.indexOf(set);
    return at < 0 ? Double.POSITIVE_INFINITY : behind[at];
  }

  /** Returns the probability that no effect of the vocabulary is at work. */
  public double ofNone() {
    double sum = 0;
    for (int i = 0; i < weight.length; i++) {
      sum += sets.get(i).hypothesis().forms().isEmpty() ? weight[i] : 0;
    }
    return sum;
  }

  /**
   * Returns the probability that an effect is at work, for each that was fitted; twins have equal
   * shares of it.
   */
  public Map<Effect, Double> ofEffects() {
    Map<Effect, Double> sums = new TreeMap<>();
    for (int i = 0; i < weight.length; i++) {
      for (Effect effect : sets.get(i).hypothesis().effects()) {
        Set<Effect> alike = twins.getOrDefault(effect, Set.of());
        double share = weight[i] / (1 + alike.size());
        sums.merge(effect, share, Double::sum);
        alike.forEach(twin -> sums.merge(twin, share, Double::sum));
      }
    }
    return sums;
  }

  /** Returns the probability that at least one of some effects is at work. */
  public double ofAny(Set<Effect> effects) {
    double sum = 0;
    for (int i = 0; i < weight.length; i++) {
      boolean hasOne = sets.get(i).hypothesis().effects().stream().anyMatch(effects::contains);
      sum += hasOne ? weight[i] : 0;
    }
    return sum;
  }

  /** Returns the ties of an effect of the most probable set: what could stand in its place. */
  public List<Effect> tiesOf(Effect effect, double nats) {
    return tiesOf(effect, best(), nats);
  }

  /**
   * Returns the ties of an effect of a set: the effects that could stand in its place with less
   * than some evidence against it. What would have to gain more than others is no rival of one that
   * has not.
   *
   * @param effect of the set
   * @param set one of those that were fitted
   * @param nats how much evidence still leaves the two alike
   */
  public List<Effect> tiesOf(Effect effect, Scored set, double nats) {
    Set<Effect> rest = new TreeSet<>(set.hypothesis().effects());
    rest.remove(effect);
    int size = rest.size() + 1;
    Stream<Effect> rivals =
        sets.stream()
            .filter(other -> other.hypothesis().forms().size() == size)
            .filter(other -> other.hypothesis().effects().containsAll(rest))
            .filter(other -> other.heldOut() > set.heldOut() - nats)
            .flatMap(other -> other.hypothesis().effects().stream())
            .filter(other -> other != effect && !rest.contains(other))
            .filter(other -> unseen.contains(effect) || !unseen.contains(other));
    return Stream.concat(twins.getOrDefault(effect, Set.of()).stream().sorted(), rivals)
        .distinct()
        .toList();
  }
}
