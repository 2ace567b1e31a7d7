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
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.Robot;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.effect.MotionParameter;

/**
 * Looks for the sets of effects that explain a log: all single ones; then, as long as it is worth
 * it, every one beside the best set, and every one in the place of each of its members. What was
 * fitted on the way is kept, so that sets can be weighed against each other.
 */
final class MotionSearch {
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
  private final MotionFitter fitter;
  private final List<MotionForm> forms;
  private final Map<Set<String>, MotionFit> fits = new LinkedHashMap<>();

  /** The largest that a set which was built upon has shown. */
  private double clumping = 1;

  MotionSearch(MotionSteps given, Robot robot) {
    this.given = given;
    fitter = new MotionFitter(given, CommandUse.of(given.runs(), robot.wheelBaseM()));
    forms = forms(robot);
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
    keep(nominal);
    List<MotionFit> added = grown(nominal, forms, REFINED);
    MotionFit set = nominal;
    while (!added.isEmpty() && promise(added.get(0)) - promise(set) > WORTH_NATS) {
      MotionFit before = set;
      set = swapped(added.get(0));
      List<MotionForm> open =
          set.hypothesis().effects().size() < 2
              ? forms
              : promising(added, before, set.hypothesis());
      added =
          set.hypothesis().effects().size() < MOST_EFFECTS ? grown(set, open, REFINED) : List.of();
    }
    replaced(set);
    return scored(set.hypothesis().effects());
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

  private double promise(MotionFit fit) {
    return fit.promise(clumping);
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
    List<MotionFit> refined =
        screened.stream().limit(most).toList().parallelStream().map(fitter::fit).toList();
    List<MotionFit> all = new ArrayList<>(refined);
    all.addAll(screened.subList(refined.size(), screened.size()));
    all.forEach(this::keep);
    return best(all.stream().filter(fit -> matters(fit.hypothesis())).toList());
  }

  /** Two forms stand beside each other only where they change different things. */
  private static boolean apart(MotionHypothesis base, MotionForm form) {
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

  /** Puts what is better in the place of each member but the last, if anything is. */
  private MotionFit swapped(MotionFit set) {
    MotionFit swapped = set;
    List<MotionForm> members = set.hypothesis().forms();
    for (int i = 0; i < members.size() - 1 && members.size() <= SWAPPED; i++) {
      MotionFit other = inPlaceOf(swapped, members.get(i).effect());
      swapped = promise(other) > promise(swapped) ? other : swapped;
    }
    return swapped;
  }

  private MotionFit inPlaceOf(MotionFit set, String effect) {
    List<MotionFit> others = beside(rest(set, effect));
    return others.isEmpty() ? set : others.get(0);
  }

  private MotionFit rest(MotionFit set, String effect) {
    return fitter.fit(fitter.with(set.hypothesis().without(effect), set.noises()));
  }

  private List<MotionFit> beside(MotionFit rest) {
    keep(rest);
    return grown(rest, forms, REFINED_IN_PLACE);
  }

  /** Fits what could stand in the place of each member, and the set without it. */
  private void replaced(MotionFit set) {
    List.copyOf(set.hypothesis().effects()).parallelStream()
        .map(effect -> rest(set, effect))
        .toList()
        .forEach(this::beside);
  }

  private List<MotionFit> best(List<MotionFit> fits) {
    return fits.stream().sorted(Comparator.comparingDouble(fit -> -promise(fit))).toList();
  }

  private void keep(MotionFit fit) {
    if (!matters(fit.hypothesis())) {
      return;
    }
    fits.merge(fit.hypothesis().effects(), fit, (a, b) -> promise(b) > promise(a) ? b : a);
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
        Comparator.comparingDouble(
            fit -> Odds.COST_NATS * fit.hypothesis().effects().size() - promise(fit));
    List<MotionFit> front = fits.values().stream().sorted(order).limit(SCORED).toList();
    Set<MotionFit> all = new LinkedHashSet<>(front);
    all.add(fits.get(Set.<String>of()));
    for (String effect : found) {
      Set<String> less = new TreeSet<>(found);
      less.remove(effect);
      Optional.ofNullable(fits.get(less)).ifPresent(all::add);
    }
    return all.parallelStream()
        .map(fit -> ScoredMotion.of(given, fit))
        .sorted(Comparator.comparingDouble(one -> -one.heldOut()))
        .toList();
  }
}
