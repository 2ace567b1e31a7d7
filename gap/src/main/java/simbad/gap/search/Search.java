package simbad.gap.search;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ForkJoinTask;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.gap.calibrate.SetupLeave;
import simbad.gap.fit.ArcSearch;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Refit;
import simbad.gap.fit.Screen;
import simbad.gap.score.Blocks;
import simbad.gap.score.HeldOut;
import simbad.gap.score.HeldOut.Scored;
import simbad.gap.score.Probabilities;
import simbad.gap.unexplained.Misfit;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;

/**
 * Looks for the sets of effects that explain a log: all single effects; then, as long as it is
 * worth it, every effect beside the best set, and every effect in the place of each of its members.
 */
public final class Search extends ForwardSearch<Effect, Fit, Effect> {
  private static final int MOST_EFFECTS = 3;
  private static final int JOINT = 3;
  private static final int PROMISING = 8;

  /** What gains less of what an effect more must gain is out of the question. */
  private static final double LEAST_SHARE = 0.25;

  private static final int RUNNERS_UP = 2;

  /** From a set that fits worse by so much than another of its size nothing better is built. */
  private static final double BEHIND_NATS = 25;

  /** A set whose greatest misfits are beyond this leaves something over. */
  private static final double OFF = 4;

  /** For each value of what stands beside a table. */
  private static final int TABLED_EVALUATIONS = 20;

  /**
   * What is further behind, in costs of an effect, is not looked at again: where an effect costs 20
   * nats, its probability is e^-4.7 of the first one's at most, at the level law's temperature.
   */
  private static final double FRONT_COSTS = 0.6;

  /** How often another set may come to stand first. */
  private static final int RIVALLED = 3;

  /** How many sets get a held-out score. */
  private static final int SCORED = 10;

  private final CalibratedLog given;
  private final HeldOut heldOut;
  private final List<Form> forms;
  private final double worthNats;
  private final Optional<SetupLeave> leave;
  private final Map<Hypothesis, Double> leaves = new ConcurrentHashMap<>();
  private final Map<Hypothesis, Double> farLeaves = new ConcurrentHashMap<>();
  private final List<Hypothesis> offered = new ArrayList<>();
  private final Set<Set<Effect>> builtUpon = new HashSet<>();
  private List<Fit> singles = List.of();
  private Fit best = new Fit(Hypothesis.NONE, Double.NEGATIVE_INFINITY);

  /**
   * Creates a search.
   *
   * @param given the log
   * @param excluded effects that are not looked for
   * @param worthNats what a further effect must gain to be built upon
   * @param leave that the set-up has; none where it stands still
   */
  public Search(
      CalibratedLog given, Set<Effect> excluded, double worthNats, Optional<SetupLeave> leave) {
    super(worthNats);
    this.given = given;
    this.leave = leave;
    this.worthNats = worthNats;
    heldOut = new HeldOut(given, new Blocks(given.log()));
    forms =
        Gates.open(given, Forms.all(given.setup(), given.log().sensors())).stream()
            .filter(form -> !excluded.contains(form.effect()))
            .toList();
  }

  /**
   * Starts from a set as well that something else than this log has told of.
   *
   * @param set of one effect or more; with values near those that fit
   */
  public void offer(Hypothesis set) {
    if (!set.forms().isEmpty() && forms.containsAll(set.forms())) {
      offered.add(set);
    }
  }

  /** Returns all sets that were fitted, the most probable held-out first. */
  public List<Scored> run() {
    Fit nominal = new Fitter(given, Fold.ALL).refine(Hypothesis.NONE, 0);
    keep(nominal);
    List<Fit> starts = new ArrayList<>(new Screen(given, nominal).all(forms).values());
    ArcSearch.starts(given, forms).forEach(this::offer);
    BehindSearch.starts(given, forms).forEach(this::offer);
    offered.forEach(set -> starts.add(joint(new Fit(set, nominal.logLikelihood()))));
    singles = best(starts);
    singles.forEach(this::keep);
    plain();
    best = pruned(built(nominal, singles));
    return rivalled();
  }

  private Fit kept(List<Effect> effects) {
    return Objects.requireNonNull(fits().get(new TreeSet<>(effects)));
  }

  /**
   * Scores, until what could stand in the place of each member of the best set was tried: what was
   * met on the way to another may be the more probable one, and its rivals were not met.
   */
  private List<Scored> rivalled() {
    List<Scored> scored = scored();
    for (int round = 0; round < RIVALLED; round++) {
      Hypothesis first = scored.get(0).hypothesis();
      List<Effect> open =
          first.effects().stream()
              .filter(member -> first.effects().size() > 1)
              .filter(member -> !builtUpon.contains(Set.copyOf(first.without(member).effects())))
              .toList();
      if (open.isEmpty()) {
        return scored;
      }
      Fit fit = kept(first.effects());
      open.forEach(member -> inPlaceOf(fit, member));
      // Its values may have been found anew, and be better for fewer effects as well.
      pruned(kept(first.effects()));
      scored = scored();
    }
    return scored;
  }

  /** The law of the ranges, and what else is plain beside it. */
  private void plain() {
    Fit law = new PlainFamily(given, forms).law();
    keep(law);
    if (law.hypothesis().forms().size() > 1) {
      grown(
          law,
          forms.stream()
              .filter(form -> PlainFamily.BESIDE_THE_LAW.contains(form.effect()))
              .toList());
    }
  }

  /** Returns whether the set that was built leaves something over. */
  public boolean isOff() {
    return Misfit.ofPings(given, best.hypothesis()).top(Misfit.TOP) > OFF;
  }

  /**
   * Searches once more from each of the runners-up: the first was perhaps only the one that soaks
   * up most.
   *
   * @return all sets that were fitted until now, the most probable held-out first
   */
  public List<Scored> further() {
    Fit nominal = kept(List.of());
    List<Effect> built = best.hypothesis().effects();
    singles.stream()
        .filter(single -> !built.containsAll(single.hypothesis().effects()))
        .limit(RUNNERS_UP)
        .forEach(single -> pruned(built(nominal, List.of(single))));
    return rivalled();
  }

  @Override
  protected List<Effect> effects(Fit set) {
    return set.hypothesis().effects();
  }

  @Override
  protected double worth(Fit set) {
    return set.logLikelihood();
  }

  /** The same effects in other forms have other values, each of which gains something by chance. */
  @Override
  protected boolean isBetter(Fit fit, Fit kept) {
    int more = fit.hypothesis().size() - kept.hypothesis().size();
    return worth(fit) - Probabilities.NATS_PER_VALUE * more > worth(kept);
  }

  @Override
  protected Fit settled(Fit set) {
    Fit settled = joint(set);
    keep(settled);
    return settled;
  }

  @Override
  protected boolean isLast(Fit set) {
    return set.hypothesis().forms().size() >= MOST_EFFECTS;
  }

  @Override
  protected List<Fit> beside(Fit set, List<Fit> added, Fit before) {
    boolean few = worth(set) - worth(before) < LEAST_SHARE * askedNats(before);
    if (isBehind(set) || few) {
      return List.of();
    }
    // What gained nothing beside fewer effects gains nothing beside more.
    boolean single = set.hypothesis().forms().size() == 1;
    return grown(set, single ? forms : promising(added, set.hypothesis()));
  }

  /** Whether another set of as many effects, two or more, fits far better. */
  private boolean isBehind(Fit set) {
    int size = set.hypothesis().forms().size();
    return size > 1
        && fits().values().stream()
            .filter(fit -> fit.hypothesis().forms().size() == size)
            .anyMatch(fit -> fit.logLikelihood() > set.logLikelihood() + BEHIND_NATS);
  }

  private List<Form> promising(List<Fit> added, Hypothesis base) {
    Set<Effect> gained =
        added.stream()
            .limit(PROMISING)
            .flatMap(fit -> fit.hypothesis().effects().stream())
            .collect(Collectors.toSet());
    return forms.stream()
        .filter(form -> gained.contains(form.effect()) && !base.has(form.effect()))
        .toList();
  }

  /** The base with one effect more, the best first; the first few with all values refined. */
  private List<Fit> grown(Fit base, List<Form> open) {
    builtUpon.add(Set.copyOf(base.hypothesis().effects()));
    List<Fit> added = best(new Screen(given, base).all(open).values());
    double least = base.logLikelihood() + LEAST_SHARE * askedNats(base);
    List<Fit> joint =
        added.stream()
            .limit(JOINT)
            .filter(fit -> fit.logLikelihood() > least)
            .toList()
            .parallelStream()
            .map(this::joint)
            .toList();
    added.forEach(this::keep);
    joint.forEach(this::keep);
    List<Fit> all = new ArrayList<>(joint);
    all.addAll(added.subList(joint.size(), added.size()));
    return best(all);
  }

  /** What an effect more must gain beside a set before the two together are the more probable. */
  private double askedNats(Fit set) {
    int size = set.hypothesis().forms().size();
    return worthNats * (Probabilities.shares(size + 1) - Probabilities.shares(size));
  }

  @Override
  protected List<Effect> exchanged(Fit set) {
    return set.hypothesis().effects();
  }

  /**
   * What explains much alone in the place of a member: the first may have been taken because it
   * soaks up what two others do. The member itself is among them, looked for anew now that the
   * others are known.
   */
  @Override
  protected List<Fit> inPlaceOf(Fit set, Effect member) {
    Hypothesis rest = set.hypothesis().without(member);
    ForkJoinTask<Fit> alone =
        ForkJoinTask.adapt(() -> joint(new Fit(rest, set.logLikelihood()))).fork();
    // Beside the values that they had beside it: alone they would do its work.
    Fit base = new Fitter(given, Fold.ALL).refine(rest, 0);
    // What gained little beside what soaked it up may gain most beside the other.
    boolean large = set.hypothesis().forms().size() > 2;
    List<Fit> grown = grown(base, large ? promising(singles, rest) : forms);
    keep(alone.join());
    return grown;
  }

  /**
   * Fits the best set without each of its members, and the best of these so again: what was added
   * first may be superfluous, and what was found beside something else may not have been found
   * alone.
   */
  private Fit pruned(Fit set) {
    if (set.hypothesis().forms().size() > 1 && !isBehind(set)) {
      List<Fit> fewer =
          best(
              set.hypothesis().effects().parallelStream()
                  .map(out -> joint(new Fit(set.hypothesis().without(out), set.logLikelihood())))
                  .toList());
      fewer.forEach(this::keep);
      pruned(fewer.get(0));
    }
    return set;
  }

  /** Refines all values of a set together, first by long steps, then by short ones. */
  private Fit joint(Fit fit) {
    int size = fit.hypothesis().size();
    Fitter fitter = new Fitter(given, Fold.ALL);
    if (fit.hypothesis().hasTable()) {
      return tabled(fit.hypothesis(), fitter);
    }
    return fitter.settle(fit.hypothesis(), 0, 20 + 20 * size, 20 + 15 * size);
  }

  /** A table is read off the log anew now that the other effects are known, if that is better. */
  private Fit tabled(Hypothesis set, Fitter fitter) {
    Fit kept = new Fit(set, fitter.logLikelihood(set));
    Hypothesis read = new Refit(given, Fold.ALL).of(set, TABLED_EVALUATIONS);
    double again = fitter.logLikelihood(read);
    return again > kept.logLikelihood() ? new Fit(read, again) : kept;
  }

  private List<Scored> scored() {
    List<Fit> ranked =
        fits().values().stream().sorted(Comparator.comparingDouble(fit -> -promise(fit))).toList();
    List<Scored> again = heldOut.score(ranked.subList(0, Math.min(SCORED, ranked.size())));
    List<Scored> scored = new ArrayList<>(again);
    ranked.stream().skip(SCORED).map(fit -> HeldOut.guess(fit, again)).forEach(scored::add);
    return HeldOut.capped(leave.map(open -> moved(scored, open)).orElse(scored)).stream()
        .sorted(Comparator.comparingDouble(one -> -one.heldOut()))
        .toList();
  }

  /** Sets before a set-up that moves with each; of those in front the values move as well. */
  private List<Scored> moved(List<Scored> sets, SetupLeave open) {
    List<Scored> moved =
        sets.parallelStream().map(one -> plus(one, once(leaves, one, open::nats))).toList();
    double first = moved.stream().mapToDouble(this::lessCost).max().orElse(0);
    double front = first - FRONT_COSTS * worthNats;
    return IntStream.range(0, sets.size())
        .parallel()
        .mapToObj(
            i ->
                lessCost(moved.get(i)) < front
                    ? moved.get(i)
                    : plus(sets.get(i), once(farLeaves, sets.get(i), open::natsWithValues)))
        .toList();
  }

  private double lessCost(Scored set) {
    return set.heldOut() - worthNats * Probabilities.shares(set.hypothesis().forms().size());
  }

  /** What costs as much as a fit is asked once of a set, however often sets are scored. */
  private static double once(
      Map<Hypothesis, Double> known, Scored set, ToDoubleFunction<Hypothesis> nats) {
    // Two threads that ask at once find the same.
    Double before = known.get(set.hypothesis());
    double now = before == null ? nats.applyAsDouble(set.hypothesis()) : before;
    known.put(set.hypothesis(), now);
    return now;
  }

  private static Scored plus(Scored set, double nats) {
    return new Scored(set.hypothesis(), set.inSample() + nats, set.heldOut() + nats);
  }

  /** What a set may reach held-out: each effect more costs what chance would gain. */
  private double promise(Fit fit) {
    return fit.logLikelihood() - worthNats * fit.hypothesis().forms().size();
  }
}
