package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import simbad.gap.search.ForwardSearch;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.motion.Robot;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.effect.MotionParameter;

/**
 * Looks for the sets of effects that explain a log: all single ones; then, as long as it is worth
 * it, every one beside the best set, and every one in the place of each of its members. What was
 * fitted on the way is kept, so that sets can be weighed against each other.
 */
final class MotionSearch extends ForwardSearch<String, MotionFit, MotionForm> {
  /** What a further effect must gain to be built upon. */
  private static final double WORTH_NATS = 5;

  private static final int MOST_EFFECTS = 6;

  /** So many of a round's best get all values and the noise fitted. */
  private static final int REFINED = 4;

  /** The same of what could stand in a member's place. */
  private static final int REFINED_IN_PLACE = 2;

  /** Larger sets are not swapped: their members were chosen beside each other. */
  private static final int SWAPPED = 3;

  /** How many sets are scored on left-out blocks. */
  private static final int SCORED = 12;

  /** What gained less of a round's best gains nothing beside more. */
  private static final double HOPELESS_NATS = 0.5;

  /** What a value of a set-up gains where it is none. */
  private static final double LEAST_NATS = 1;

  private final MotionSteps given;
  private final Robot robot;
  private final MotionFitter fitter;
  private final PlainFactors factors;
  private final List<MotionForm> forms;

  /** The largest that a set which was built upon has shown. */
  private double clumping = 1;

  MotionSearch(MotionSteps given, Robot robot) {
    this(given, robot, forms(robot));
  }

  private MotionSearch(MotionSteps given, Robot robot, List<MotionForm> forms) {
    super(WORTH_NATS);
    this.given = given;
    this.robot = robot;
    this.forms = forms;
    factors = new PlainFactors(given.runs());
    fitter = new MotionFitter(given, CommandUse.of(given.runs(), robot.wheelBaseM()));
  }

  /** Returns the forms that are looked for: a clock of its own only where there may be one. */
  static List<MotionForm> forms(Robot robot) {
    return MotionForms.of(robot).stream()
        .filter(form -> robot.separateClocks() || !form.clocks())
        .toList();
  }

  /** Returns sets that were fitted, the likeliest on left-out blocks first. */
  List<ScoredMotion> run(MotionChain base) {
    MotionFit nominal = fitter.asItIs(new MotionHypothesis(base, List.of(), new double[0]));
    keepIfItMatters(nominal);
    MotionFit set = plain(built(nominal, grown(nominal, forms, REFINED)));
    replaced(set);
    return scored(set.hypothesis().effects());
  }

  /**
   * Returns another search, which does not look for an effect.
   *
   * @param effect that is no longer looked for
   */
  MotionSearch without(String effect) {
    return new MotionSearch(
        given, robot, forms.stream().filter(one -> !one.effect().equals(effect)).toList());
  }

  /**
   * Returns sets about one, which is fitted anew and built upon.
   *
   * @param base what was believed
   * @param found the set
   */
  List<ScoredMotion> about(MotionChain base, MotionHypothesis found) {
    keepIfItMatters(fitter.asItIs(new MotionHypothesis(base, List.of(), new double[0])));
    MotionFit start = fitter.fit(fitter.asItIs(found));
    keepIfItMatters(start);
    MotionFit set = plain(built(start, grown(start, forms, REFINED)));
    Set<String> effects = set.hypothesis().effects();
    effects.forEach(one -> keepIfItMatters(rest(set, one)));
    return scored(effects);
  }

  @Override
  protected Set<String> effects(MotionFit set) {
    return set.hypothesis().effects();
  }

  /** Less what another log would miss of it. */
  @Override
  protected double worth(MotionFit set) {
    return set.promise(clumping);
  }

  @Override
  protected MotionFit settled(MotionFit set) {
    return set;
  }

  @Override
  protected boolean isLast(MotionFit set) {
    return set.hypothesis().effects().size() >= MOST_EFFECTS;
  }

  @Override
  protected List<MotionFit> beside(MotionFit set, List<MotionFit> added, MotionFit before) {
    if (isLast(set)) {
      return List.of();
    }
    boolean single = set.hypothesis().effects().size() < 2;
    return grown(set, single ? forms : promising(added, before, set.hypothesis()), REFINED);
  }

  /**
   * Adds to an explanation of a reference whatever makes left-out blocks likelier, however small:
   * what a set-up is off by anyway is nobody's change.
   */
  ScoredMotion calibrated(ScoredMotion from) {
    ScoredMotion best = from;
    boolean better = true;
    while (better) {
      MotionFit base = best.fit();
      Slopes slopes = best.slopes();
      Optional<ScoredMotion> next =
          MotionForms.PLAIN.parallelStream()
              .filter(form -> apart(base.hypothesis(), form))
              .map(form -> ScoredMotion.of(given, fitter.fit(fitter.screened(slopes, form))))
              .max(Comparator.comparingDouble(ScoredMotion::heldOut));
      better = next.isPresent() && next.get().heldOut() > best.heldOut() + LEAST_NATS;
      best = better ? next.get() : best;
    }
    return best;
  }

  /**
   * Builds upon a set anew where a member is worth more as plain factors: a scale of the wheels, or
   * steps or limits that only look like it. No single step leads from it to two.
   */
  private MotionFit plain(MotionFit set) {
    MotionHypothesis found = set.hypothesis();
    for (int i = 0; i < found.forms().size(); i++) {
      MotionForm form = found.forms().get(i);
      List<MotionForm> scales =
          form.scalesBoth() ? MotionForms.SCALES : factors.scales(found.changes().get(i));
      if (!scales.isEmpty()) {
        MotionFit fit = fitter.fit(fitter.with(scaled(found, form, scales), set.noises()));
        keepIfItMatters(fit);
        if (matters(fit.hypothesis()) && worth(fit) - worth(set) > WORTH_NATS) {
          return built(fit, isLast(fit) ? List.of() : grown(fit, forms, REFINED));
        }
      }
    }
    return set;
  }

  /** Puts scales in the place of a member. */
  private MotionHypothesis scaled(MotionHypothesis set, MotionForm form, List<MotionForm> scales) {
    MotionHypothesis scaled = set.without(form);
    for (MotionForm scale : scales) {
      boolean isOpen = forms.contains(scale) && apart(scaled, scale);
      scaled = isOpen ? scaled.with(scale, scale.neutralValues()) : scaled;
    }
    return scaled;
  }

  /** What is factors only is built upon as scales; as it is, it is weighed against them. */
  private MotionFit inPlain(MotionFit set) {
    MotionHypothesis plain = set.hypothesis();
    for (MotionForm form : set.hypothesis().forms()) {
      MotionChange change = form.change(set.hypothesis().values(form));
      if (factors.isFactors(change)) {
        plain = scaled(plain, form, factors.scales(change));
      }
    }
    return fitter.fit(fitter.with(plain, set.noises()));
  }

  private static List<MotionForm> promising(
      List<MotionFit> added, MotionFit before, MotionHypothesis set) {
    double floor = before.score() + HOPELESS_NATS;
    return added.stream()
        .filter(fit -> fit.score() > floor)
        .map(fit -> last(fit.hypothesis()))
        .filter(form -> !set.forms().contains(form))
        .distinct()
        .collect(Collectors.toList());
  }

  private static MotionForm last(MotionHypothesis set) {
    return set.forms().get(set.forms().size() - 1);
  }

  /** The base with one form more, the best first. */
  private List<MotionFit> grown(MotionFit base, List<MotionForm> open, int most) {
    Slopes slopes = new Slopes(given, base);
    clumping = Math.max(clumping, slopes.linear().clumping());
    List<MotionFit> screened =
        best(
            open.parallelStream()
                .filter(form -> apart(base.hypothesis(), form))
                .map(form -> fitter.screened(slopes, form))
                .toList());
    Set<MotionFit> promising =
        most == REFINED_IN_PLACE ? ofEachEffect(screened, most) : first(screened, most);
    List<MotionFit> all = new ArrayList<>(promising.parallelStream().map(fitter::fit).toList());
    screened.stream().filter(fit -> !promising.contains(fit)).forEach(all::add);
    all.forEach(this::keepIfItMatters);
    List<MotionFit> fitted = best(all.stream().filter(fit -> matters(fit.hypothesis())).toList());
    List<MotionFit> plain =
        new ArrayList<>(
            fitted.stream()
                .limit(most)
                .filter(fit -> !factors.isPlain(fit.hypothesis()))
                .map(this::inPlain)
                .toList());
    plain.forEach(this::keepIfItMatters);
    fitted.stream().filter(fit -> factors.isPlain(fit.hypothesis())).forEach(plain::add);
    return best(plain.stream().filter(fit -> matters(fit.hypothesis())).toList());
  }

  private static Set<MotionFit> first(List<MotionFit> ranked, int most) {
    return new LinkedHashSet<>(ranked.subList(0, Math.min(most, ranked.size())));
  }

  /**
   * The best form of each of a few effects: two forms of one effect would leave out what could
   * stand in its place, such as a scale of the speeds in that of their steps.
   */
  private static Set<MotionFit> ofEachEffect(List<MotionFit> ranked, int most) {
    Map<String, MotionFit> best = new LinkedHashMap<>();
    ranked.forEach(fit -> best.putIfAbsent(last(fit.hypothesis()).effect(), fit));
    return first(new ArrayList<>(best.values()), most);
  }

  /** Two forms stand beside each other only where they change different things. */
  private static boolean apart(MotionHypothesis base, MotionForm form) {
    if (form.followsALag() && base.chain().responses().isEmpty()) {
      return false;
    }
    for (MotionForm one : base.forms()) {
      boolean same = one.effect().equals(form.effect()) && sharesName(one, form);
      if (same || one.doublesWith(form)) {
        return false;
      }
    }
    return true;
  }

  private static boolean sharesName(MotionForm one, MotionForm other) {
    Set<String> names =
        one.parameters().stream().map(MotionParameter::name).collect(Collectors.toSet());
    return other.parameters().stream().map(MotionParameter::name).anyMatch(names::contains);
  }

  /** Of a small set only. */
  @Override
  protected List<MotionForm> exchanged(MotionFit set) {
    List<MotionForm> members = set.hypothesis().forms();
    return members.size() > SWAPPED ? List.of() : members;
  }

  @Override
  protected List<MotionFit> inPlaceOf(MotionFit set, MotionForm member) {
    return beside(rest(set, member.effect()));
  }

  private MotionFit rest(MotionFit set, String effect) {
    return fitter.fit(fitter.with(set.hypothesis().without(effect), set.noises()));
  }

  private List<MotionFit> beside(MotionFit rest) {
    keepIfItMatters(rest);
    return grown(rest, forms, REFINED_IN_PLACE);
  }

  /** Fits what could stand in the place of each member, and the set without it. */
  private void replaced(MotionFit set) {
    List.copyOf(set.hypothesis().effects()).parallelStream()
        .map(effect -> rest(set, effect))
        .toList()
        .forEach(this::beside);
  }

  /** Returns what a set would be without each of its effects. */
  List<ScoredMotion> rests(ScoredMotion set) {
    return List.copyOf(set.hypothesis().effects()).parallelStream()
        .map(effect -> rest(set.fit(), effect))
        .filter(fit -> matters(fit.hypothesis()))
        .map(fit -> ScoredMotion.of(given, fit))
        .toList();
  }

  private void keepIfItMatters(MotionFit fit) {
    if (matters(fit.hypothesis())) {
      keep(fit);
    }
  }

  /** What is off by less than half of what would matter to anybody is no effect. */
  private static boolean matters(MotionHypothesis hypothesis) {
    return hypothesis.forms().stream().allMatch(form -> matters(form, hypothesis.values(form)));
  }

  private static boolean matters(MotionForm form, double[] values) {
    for (int i = 0; i < values.length; i++) {
      MotionParameter parameter = form.parameters().get(i);
      if (Math.abs(values[i] - parameter.neutral()) >= parameter.practical() / 2) {
        return true;
      }
    }
    return false;
  }

  /** The most promising, and what the found set would be without each of its effects. */
  private List<ScoredMotion> scored(Set<String> found) {
    Comparator<MotionFit> order =
        Comparator.comparingDouble(fit -> factors.costNats(fit.hypothesis()) - worth(fit));
    List<MotionFit> front = fits().values().stream().sorted(order).limit(SCORED).toList();
    Set<MotionFit> all = new LinkedHashSet<>(front);
    all.add(fits().get(Set.<String>of()));
    for (String effect : found) {
      Set<String> less = new TreeSet<>(found);
      less.remove(effect);
      Optional.ofNullable(fits().get(less)).ifPresent(all::add);
    }
    return all.parallelStream()
        .map(fit -> ScoredMotion.of(given, fit))
        .sorted(Comparator.comparingDouble(one -> -one.heldOut()))
        .toList();
  }
}
