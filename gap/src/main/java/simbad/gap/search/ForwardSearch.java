package simbad.gap.search;

import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import simbad.sonar.check.Checks;

/**
 * Builds a set of effects, one after the other, whatever the log is of: the best single one first;
 * then, as long as it is worth it, the best one beside the set, after which each member but that
 * last is looked for anew. The best fit of every set that was met on the way is kept.
 *
 * @param <E> an effect
 * @param <F> a set of effects, fitted
 * @param <M> a member of a set that is exchanged for another
 */
public abstract class ForwardSearch<E extends Comparable<? super E>, F, M> {
  private final double worthNats;
  private final Map<Set<E>, F> fits = new LinkedHashMap<>();

  /**
   * Prepares a search.
   *
   * @param worthNats what a further effect must gain to be built upon
   */
  protected ForwardSearch(double worthNats) {
    this.worthNats = Checks.number("worthNats", worthNats);
  }

  /** Returns the effects of a set. */
  protected abstract Collection<E> effects(F set);

  /** Returns what a set is worth, nats: the larger the better. */
  protected abstract double worth(F set);

  /** Returns the members of a set that may be exchanged before it is built upon, in this order. */
  protected abstract List<M> exchanged(F set);

  /** Returns a set with what could stand in the place of a member, the best first. */
  protected abstract List<F> inPlaceOf(F set, M member);

  /** Returns the set as it is built upon, after members were exchanged. */
  protected abstract F settled(F set);

  /** Tells whether a set is as large as it may be. */
  protected abstract boolean isLast(F set);

  /**
   * Returns the set with one effect more, the best first; nothing where it is not built upon.
   *
   * @param set that is built upon
   * @param added what stood beside the set before, among them this one
   * @param before the set before
   */
  protected abstract List<F> beside(F set, List<F> added, F before);

  /** Builds upon the first of some sets as long as it is worth it. */
  protected final F built(F nominal, List<F> starts) {
    F set = nominal;
    List<F> added = starts;
    while (!added.isEmpty() && worth(added.get(0)) - worth(set) > worthNats && !isLast(set)) {
      F before = set;
      set = settled(swapped(added.get(0)));
      added = beside(set, added, before);
    }
    return set;
  }

  /**
   * The last member was just chosen among all, and stays: unless another came beside which it was
   * not chosen.
   */
  private F swapped(F set) {
    List<M> members = exchanged(set);
    F swapped = set;
    for (int i = 0; i < members.size(); i++) {
      boolean isLast = i == members.size() - 1;
      if (!isLast || !effects(swapped).containsAll(effects(set))) {
        swapped = exchanged(swapped, members.get(i));
      }
    }
    return swapped;
  }

  private F exchanged(F set, M member) {
    List<F> others = inPlaceOf(set, member);
    boolean better = !others.isEmpty() && worth(others.get(0)) > worth(set);
    return better ? others.get(0) : set;
  }

  /** Keeps a fit unless one of the same effects is as good. */
  protected final void keep(F fit) {
    fits.merge(new TreeSet<>(effects(fit)), fit, (a, b) -> isBetter(b, a) ? b : a);
  }

  /** Tells whether a fit is better than another one of the same effects. */
  protected boolean isBetter(F fit, F kept) {
    return worth(fit) > worth(kept);
  }

  /** Returns the best fit of each set that was kept, by its effects, in the order of coming. */
  protected final Map<Set<E>, F> fits() {
    return fits;
  }

  /** Returns fits, the best first. */
  protected final List<F> best(Collection<F> all) {
    return all.stream().sorted(Comparator.comparingDouble(fit -> -worth(fit))).toList();
  }
}
