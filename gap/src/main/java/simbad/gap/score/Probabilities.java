package simbad.gap.score;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
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
  private final Function<Hypothesis, Set<Effect>> invited;
  private final Map<Effect, Set<Effect>> twins;
  private final Weights<Effect> weights;

  /**
   * Weighs sets of effects without twins.
   *
   * @param sets with their held-out scores
   * @param costNats what a further effect must gain to be as probable as its absence
   * @param temperature by which nats are divided
   * @param unseen effects that do not show in the gap
   */
  public Probabilities(List<Scored> sets, double costNats, double temperature, Set<Effect> unseen) {
    this(sets, costNats, temperature, unseen, set -> Set.of(), Map.of());
  }

  /**
   * Weighs sets.
   *
   * @param sets with their held-out scores
   * @param costNats what a further effect must gain to be as probable as its absence
   * @param temperature by which nats are divided: likelihoods of models that are all a little
   *     wrong, of readings that hang together, are taken for less than they say
   * @param unseen effects that do not show in the gap
   * @param invited effects of a set that the way in which the log was taken invites: they are to be
   *     expected, and cost nothing, shown in the gap or not
   * @param twins of an effect: what the log cannot tell from it because of how it was taken, and
   *     what is in none of the sets
   */
  public Probabilities(
      List<Scored> sets,
      double costNats,
      double temperature,
      Set<Effect> unseen,
      Function<Hypothesis, Set<Effect>> invited,
      Map<Effect, Set<Effect>> twins) {
    Checks.number("costNats", costNats);
    Checks.positive("temperature", temperature);
    this.sets = List.copyOf(sets);
    this.unseen = Set.copyOf(unseen);
    this.invited = invited;
    this.twins = Map.copyOf(twins);
    weights =
        new Weights<>(
            sets.stream().<Set<Effect>>map(set -> new TreeSet<>(effects(set))).toList(),
            sets.stream().mapToDouble(set -> nats(set, costNats) / temperature).toArray());
  }

  private double nats(Scored set, double costNats) {
    Set<Effect> dear = new TreeSet<>(effects(set));
    dear.removeAll(invited.apply(set.hypothesis()));
    double shares = shares(dear.size());
    shares += UNSEEN * dear.stream().filter(unseen::contains).count();
    return set.heldOut() - costNats * shares - NATS_PER_VALUE * values(set.hypothesis());
  }

  private static List<Effect> effects(Scored set) {
    return set.hypothesis().effects();
  }

  /**
   * How many times the cost of one effect some effects cost together: three at once are rare, and
   * what needs them is more often one thing that has no name.
   *
   * @param effects how many
   */
  public static double shares(int effects) {
    return effects + 3.0 * Math.max(0, effects - 2) * Math.max(0, effects - 1) / 2;
  }

  /** Of sets that predict alike the one with fewer values is likelier; a table counts as one. */
  private static int values(Hypothesis set) {
    return set.forms().stream().mapToInt(f -> f.isTable() ? 1 : f.parameters().size()).sum();
  }

  /** Returns the most probable set. */
  public Scored best() {
    return sets.get(weights.best());
  }

  /**
   * Returns by how many natural logarithms a set's probability is behind the most probable one's;
   * infinity for a set that was left out.
   */
  public double behind(Scored set) {
    int at = sets.indexOf(set);
    return at < 0 ? Double.POSITIVE_INFINITY : weights.behind(at);
  }

  /** Returns the probability that no effect of the vocabulary is at work. */
  public double ofNone() {
    return weights.of(Set::isEmpty);
  }

  /**
   * Returns the probability that an effect is at work, for each that was fitted; twins have equal
   * shares of it.
   */
  public Map<Effect, Double> ofEffects() {
    return weights.ofEffects(effect -> twins.getOrDefault(effect, Set.of()));
  }

  /** Returns the probability that at least one of some effects is at work. */
  public double ofAny(Set<Effect> effects) {
    return weights.of(set -> set.stream().anyMatch(effects::contains));
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
    Set<Effect> own = new TreeSet<>(effects(set));
    Stream<Effect> rivals =
        weights
            .without(effect, own)
            .filter(other -> effects(sets.get(other)).size() == own.size())
            .filter(other -> sets.get(other).heldOut() > set.heldOut() - nats)
            .boxed()
            .flatMap(other -> weights.beyond(other, own).stream())
            .filter(other -> unseen.contains(effect) || !unseen.contains(other));
    return Stream.concat(twins.getOrDefault(effect, Set.of()).stream().sorted(), rivals)
        .distinct()
        .toList();
  }
}
