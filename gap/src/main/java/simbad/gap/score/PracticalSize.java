package simbad.gap.score;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import simbad.definition.Effect;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.HeldOut.Scored;

/**
 * Which effects of an explanation do not show in the gap: with many rows an effect is found long
 * before it matters, and what does not shrink the gap has to gain more.
 */
public final class PracticalSize {
  /** By how many standard errors an effect shrinks the gap of rows that the fit never saw. */
  private static final double SHOWN = 1.5;

  /**
   * A gap at two places of a log shrinks by 1.4 standard errors at most: blocks that have none
   * count as well. What takes away so much of a gap that is plainly there shows in it all the same.
   */
  private static final double MOST = 0.5;

  private final GapGains gains;
  private final List<Scored> sets;

  /**
   * Creates a judge.
   *
   * @param gains of the log
   * @param sets that were fitted, with their scores
   */
  public PracticalSize(GapGains gains, List<Scored> sets) {
    this.gains = gains;
    this.sets = List.copyOf(sets);
  }

  /**
   * Returns the effects of a set that do not show in the gap, of those whose evidence is under a
   * bound; what gains more is there, however little the gap's quantiles see of it.
   *
   * @param set one of those that were fitted
   * @param nats the bound
   */
  public Set<Effect> unseen(Scored set, double nats) {
    Set<Effect> unseen = new TreeSet<>();
    for (Effect effect : set.hypothesis().effects()) {
      Optional<Scored> less = find(set.hypothesis().without(effect));
      if (less.isPresent()
          && set.heldOut() - less.get().heldOut() < nats
          && !shows(less.get().hypothesis(), set.hypothesis())) {
        unseen.add(effect);
      }
    }
    return unseen;
  }

  private Optional<Scored> find(Hypothesis like) {
    Set<Effect> effects = Set.copyOf(like.effects());
    return sets.stream()
        .filter(set -> Set.copyOf(set.hypothesis().effects()).equals(effects))
        .findFirst();
  }

  private boolean shows(Hypothesis without, Hypothesis with) {
    GapGain before = gains.of(without);
    boolean isMost = before.leavesMuch() && gains.of(with).afterM() <= (1 - MOST) * before.afterM();
    return isMost || shrinkage(without, with) >= SHOWN;
  }

  /** How much the gap shrinks from one hypothesis to another, in standard errors over blocks. */
  private double shrinkage(Hypothesis from, Hypothesis to) {
    Blocks blocks = gains.blocks();
    double[] before = gains.of(from).after().observedM();
    double[] after = gains.of(to).after().observedM();
    double[] sums = new double[blocks.count()];
    double all = 0;
    for (int i = 0; i < before.length; i++) {
      sums[blocks.of(i)] += before[i] - after[i];
      all += before[i] - after[i];
    }
    double squares = 0;
    for (double sum : sums) {
      double off = sum - all / sums.length;
      squares += off * off;
    }
    double variance = squares * sums.length / Math.max(1, sums.length - 1);
    return variance > 0 ? all / Math.sqrt(variance) : 0;
  }
}
