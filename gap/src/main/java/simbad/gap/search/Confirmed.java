package simbad.gap.search;

import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Trait;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.HeldOut.Scored;
import simbad.gap.score.Probabilities;
import simbad.sonar.effect.Definitions;
import simbad.sonar.ping.MemoryChange;

/**
 * Effects that are at work beyond doubt, though something is left over beside them. A near clamp
 * that every second reading shows is there, whatever else is.
 */
public final class Confirmed {
  private static final Set<Effect> KNOWING = Definitions.with(Trait.KNOWS_THE_PING_BEFORE);

  /** What makes ranges longer or shorter. */
  static final Set<Effect> MOVING = Collections.unmodifiableSet(moving());

  private final List<Scored> sets;
  private final Set<Effect> doubtful;
  private final Function<Hypothesis, Set<Effect>> invited;
  private final double worthNats;
  private final boolean isPlaced;
  private final boolean isJudged;

  /**
   * Creates a judge of sets.
   *
   * @param sets that were fitted, with their held-out scores
   * @param doubtful effects that take up a little of anything, and are never sure beside a rest
   * @param invited effects of a set that are to be expected of a log that was taken so: they may be
   *     sure though they show in the gap as little as others that would have to gain more
   * @param worthNats what a further effect must gain to be as probable as its absence
   * @param isPlaced whether many readings are of one placement: what takes up a little of anything
   *     then knows each placement, and that it predicts better says nothing
   * @param isDone whether the most probable set takes away most of the gap, or what moves ranges is
   *     tied: what is superfluous beside what does the work does none of it
   */
  Confirmed(
      List<Scored> sets,
      Set<Effect> doubtful,
      Function<Hypothesis, Set<Effect>> invited,
      double worthNats,
      boolean isPlaced,
      boolean isDone) {
    this.isPlaced = isPlaced;
    this.sets = List.copyOf(sets);
    this.doubtful = Set.copyOf(doubtful);
    this.invited = invited;
    this.worthNats = worthNats;
    isJudged = isPlaced && isDone;
  }

  private static Set<Effect> moving() {
    Set<Effect> moving = new TreeSet<>(Definitions.with(Trait.MOVES_RANGES));
    moving.addAll(Definitions.with(Trait.MOVES_SOME_RANGES));
    return moving;
  }

  /**
   * Returns what is sure of the best set, or of the best of those that predict nearly as well:
   * effects that would be named even if they did not show in the gap, since leaving one out costs
   * so much, and of which no other one in its place does nearly as well. What stands beside them in
   * the set takes up the rest, for want of something better, and is not named. What is sure in a
   * set that is far worse only does the work of what the best set has.
   */
  public Optional<Scored> best() {
    double most = sets.stream().mapToDouble(this::worth).max().orElse(0);
    return sets.stream()
        .filter(set -> isPlaced || worth(set) > most - worthNats)
        .sorted(Comparator.comparingDouble((Scored set) -> worth(set)).reversed())
        .map(this::sure)
        .flatMap(Optional::stream)
        .findFirst();
  }

  private Optional<Scored> sure(Scored set) {
    Hypothesis sure = set.hypothesis();
    for (Effect effect : set.hypothesis().effects()) {
      boolean stays =
          isSure(effect, set) && (!isJudged || isByDesign(effect, set) || isSureInTheBest(effect));
      sure = stays ? sure : sure.without(effect);
    }
    Set<Effect> named = Set.copyOf(sure.effects());
    return named.isEmpty() ? Optional.empty() : find(named);
  }

  /**
   * Whether nothing speaks against an effect in the best set that has it. Where places are known to
   * what takes up a little of anything, sets that are far worse count as well; but an effect that
   * is superfluous beside what predicts best, or that has a rival there, would be sure in some set
   * whose rivals were never fitted. What remembers the reading before knows the placement, and is
   * no judge.
   */
  private boolean isSureInTheBest(Effect effect) {
    return sets.stream()
        .filter(set -> set.hypothesis().has(effect))
        .filter(set -> !knowsThePingBefore(set.hypothesis()))
        .max(Comparator.comparingDouble(Scored::heldOut))
        .map(set -> gain(effect, set).orElse(worthNats) >= worthNats && !hasRival(effect, set))
        .orElse(true);
  }

  private static boolean isByDesign(Effect effect, Scored set) {
    Hypothesis all = set.hypothesis();
    return IntStream.range(0, all.forms().size())
        .filter(i -> all.forms().get(i).effect() == effect)
        .anyMatch(i -> Definitions.of(effect).isByDesign(all.forms().get(i), all.valuesOf(i)));
  }

  private static boolean knowsThePingBefore(Hypothesis set) {
    return set.effects().stream().anyMatch(KNOWING::contains)
        || set.changes().stream().anyMatch(c -> c instanceof MemoryChange || c.looksBack());
  }

  private boolean isSure(Effect effect, Scored set) {
    return (!doubtful.contains(effect) || isInvited(effect, set))
        && !isAtBound(effect, set.hypothesis())
        && !makesUpForAnother(effect, set.hypothesis())
        && gain(effect, set).orElse(0.0) > askedNats(effect, set)
        && !hasRival(effect, set);
  }

  private boolean isInvited(Effect effect, Scored set) {
    return invited.apply(set.hypothesis()).contains(effect);
  }

  private double askedNats(Effect effect, Scored set) {
    return isInvited(effect, set) ? worthNats : (1 + Probabilities.UNSEEN) * worthNats;
  }

  /** What leaving it out costs, nats; empty if that was not fitted. */
  private Optional<Double> gain(Effect effect, Scored set) {
    return find(Set.copyOf(set.hypothesis().without(effect).effects()))
        .map(without -> set.heldOut() - without.heldOut());
  }

  private boolean hasRival(Effect effect, Scored set) {
    return sets.stream().anyMatch(other -> isRival(other, effect, set));
  }

  /**
   * Whether another set has another effect in the place of one, and does nearly as well; what takes
   * up a little of anything has to do better.
   */
  private boolean isRival(Scored other, Effect effect, Scored set) {
    List<Effect> rest = set.hypothesis().without(effect).effects();
    List<Effect> others = other.hypothesis().effects();
    return others.size() == rest.size() + 1
        && !others.contains(effect)
        && others.containsAll(rest)
        && (isDoubtful(others, rest)
            ? !isPlaced && worth(other) > worth(set)
            : worth(other) > worth(set) - worthNats);
  }

  /** What is to be expected does not have to gain what others have to, nats. */
  private double worth(Scored set) {
    return set.heldOut() + worthNats * invited.apply(set.hypothesis()).size();
  }

  /** Whether what the first have beside the others is doubtful. */
  private boolean isDoubtful(List<Effect> some, List<Effect> others) {
    return some.stream().anyMatch(effect -> doubtful.contains(effect) && !others.contains(effect));
  }

  private static boolean isAtBound(Effect effect, Hypothesis set) {
    Hypothesis alone = set;
    for (Effect other : set.effects()) {
      alone = other == effect ? alone : alone.without(other);
    }
    return alone.isAtBound();
  }

  /**
   * Whether another effect on the ranges stands at an end of the search: what that one cannot do,
   * this one makes up for, and its value says nothing.
   */
  private static boolean makesUpForAnother(Effect effect, Hypothesis set) {
    return MOVING.contains(effect)
        && set.effects().stream()
            .anyMatch(other -> other != effect && MOVING.contains(other) && isAtBound(other, set));
  }

  private Optional<Scored> find(Set<Effect> effects) {
    return sets.stream()
        .filter(set -> Set.copyOf(set.hypothesis().effects()).equals(effects))
        .findFirst();
  }
}
