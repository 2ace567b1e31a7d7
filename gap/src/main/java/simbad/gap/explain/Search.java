package simbad.gap.explain;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Screen;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;

/**
 * Looks for the sets of effects that explain a log: all single effects; then, as long as it is
 * worth it, every effect beside the best set, and every effect in the place of each of its members.
 */
public final class Search {
  private static final int MOST_EFFECTS = 4;
  private static final int JOINT = 3;

  /** How many sets get a held-out score. */
  private static final int SCORED = 14;

  private final Evidence evidence;
  private final Blocks blocks;
  private final List<Form> forms;
  private final double worthNats;
  private final Map<Set<Effect>, Fit> fits = new LinkedHashMap<>();

  /**
   * Creates a search.
   *
   * @param evidence the log
   * @param excluded effects that are not looked for
   * @param worthNats what a further effect must gain to be built upon
   */
  public Search(Evidence evidence, Set<Effect> excluded, double worthNats) {
    this.evidence = evidence;
    this.worthNats = worthNats;
    blocks = new Blocks(evidence.log());
    forms =
        Forms.all(evidence.setup(), evidence.log().sensors()).stream()
            .filter(form -> !excluded.contains(form.effect()))
            .toList();
  }

  /** Returns all sets that were fitted, the most probable held-out first. */
  public List<Scored> run() {
    Fit best = new Fitter(evidence, Fold.ALL).refine(Hypothesis.NONE, 0);
    keep(best);
    for (int size = 1; size <= MOST_EFFECTS; size++) {
      Optional<Fit> grown = grow(best);
      if (grown.isEmpty()) {
        break;
      }
      best = size == 1 ? grown.get() : swapped(grown.get());
    }
    return scored();
  }

  /** The best set with one effect more, if it is worth it. */
  private Optional<Fit> grow(Fit base) {
    List<Fit> added = best(new Screen(evidence, base).all(forms).values());
    added.forEach(this::keep);
    if (!base.hypothesis().forms().isEmpty()) {
      added = added.stream().limit(JOINT).toList().parallelStream().map(this::joint).toList();
      added.forEach(this::keep);
    }
    return best(added).stream()
        .findFirst()
        .filter(fit -> fit.logLikelihood() - base.logLikelihood() > worthNats);
  }

  /** Puts every effect in the place of each but the last, which was just chosen among all. */
  private Fit swapped(Fit set) {
    Fit best = set;
    List<Effect> members = set.hypothesis().effects();
    for (Effect member : members.subList(0, members.size() - 1)) {
      Hypothesis rest = best.hypothesis().without(member);
      Fit base = new Fitter(evidence, Fold.ALL).refine(rest, 20 + 15 * rest.size());
      keep(base);
      Optional<Fit> other = grow(base);
      if (other.isPresent() && other.get().logLikelihood() > best.logLikelihood()) {
        best = other.get();
      }
    }
    return best;
  }

  private Fit joint(Fit fit) {
    int size = fit.hypothesis().size();
    return size > 12
        ? fit
        : new Fitter(evidence, Fold.ALL).refine(fit.hypothesis(), 30 + 25 * size);
  }

  private static List<Fit> best(Collection<Fit> all) {
    return all.stream().sorted(Comparator.comparingDouble(fit -> -fit.logLikelihood())).toList();
  }

  private void keep(Fit fit) {
    fits.merge(
        new TreeSet<>(fit.hypothesis().effects()),
        fit,
        (a, b) -> a.logLikelihood() >= b.logLikelihood() ? a : b);
  }

  private List<Scored> scored() {
    List<Fit> ranked =
        fits.values().stream().sorted(Comparator.comparingDouble(fit -> -promise(fit))).toList();
    List<Scored> scored =
        new ArrayList<>(
            ranked.stream().limit(SCORED).toList().parallelStream().map(this::score).toList());
    ranked.stream().skip(SCORED).map(this::guess).forEach(scored::add);
    scored.sort(Comparator.comparingDouble(one -> -one.heldOut()));
    return List.copyOf(scored);
  }

  /** What a set may reach held-out: each effect more costs what chance would gain. */
  private double promise(Fit fit) {
    return fit.logLikelihood() - worthNats * fit.hypothesis().forms().size();
  }

  private Scored guess(Fit fit) {
    return new Scored(
        fit.hypothesis(), fit.logLikelihood(), fit.logLikelihood() - fit.hypothesis().size());
  }

  private Scored score(Fit fit) {
    Hypothesis hypothesis = fit.hypothesis();
    if (hypothesis.size() == 0) {
      return guess(fit);
    }
    double heldOut = 0;
    for (int half = 0; half < 2; half++) {
      Fitter fitter = new Fitter(evidence, blocks.half(half));
      int evaluations = hypothesis.size() > 12 ? 0 : 10 + 12 * hypothesis.size();
      Fit fitted = fitter.refine(hypothesis, evaluations);
      heldOut += new Fitter(evidence, blocks.half(1 - half)).logLikelihood(fitted.hypothesis());
    }
    return new Scored(hypothesis, fit.logLikelihood(), heldOut);
  }
}
