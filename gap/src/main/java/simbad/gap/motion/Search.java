package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import simbad.motion.MotionChain;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.effect.MotionParameter;

/**
 * Finds the forms that account for a log: the one that foretells left-out blocks best is taken,
 * then the next beside it; what the others make needless is dropped again.
 */
final class Search {
  /** Some sixteen forms are tried in a round: by chance one in fifty logs would show so much. */
  private static final double TAKEN_Z = 3;

  private static final double KEPT_Z = 2;

  /** That many of a round's best are checked on left-out blocks. */
  private static final int CHECKED = 3;

  private static final int MOST_FORMS = 6;

  /** Log units within which another form does as well: likelihood ratio 20. */
  private static final double TIE = 3;

  private final Evidence evidence;
  private final Fitter fitter;
  private final List<MotionForm> forms;

  Search(Evidence evidence, boolean separateClocks) {
    this.evidence = evidence;
    fitter = new Fitter(evidence);
    forms = MotionForms.ALL.stream().filter(form -> separateClocks || !form.clocks()).toList();
  }

  HeldOut nominal(MotionChain base) {
    Hypothesis nothing = new Hypothesis(base, List.of(), new double[0]);
    return HeldOut.of(evidence, fitter.fit(nothing, fitter.all()));
  }

  HeldOut search(HeldOut nominal) {
    HeldOut best = nominal;
    Optional<HeldOut> next = next(best);
    for (int round = 0; next.isPresent() && round < MOST_FORMS; round++) {
      best = pruned(next.get());
      next = next(best);
    }
    return best;
  }

  private Optional<HeldOut> next(HeldOut now) {
    Optional<HeldOut> best = Optional.empty();
    if (now.full().hypothesis().forms().size() >= MOST_FORMS) {
      return best;
    }
    double bestGain = 0;
    for (Fit fit : candidates(now.full().hypothesis(), CHECKED)) {
      HeldOut tried = HeldOut.of(evidence, fit);
      double gain = sum(tried) - sum(now);
      if (gain > bestGain && tried.z(now) > TAKEN_Z && matters(fit.hypothesis())) {
        best = Optional.of(tried);
        bestGain = gain;
      }
    }
    return best;
  }

  private List<Fit> candidates(Hypothesis base, int most) {
    return forms.parallelStream()
        .filter(form -> !base.forms().contains(form) && apart(base, form))
        .map(form -> fitter.fitWith(base, form, fitter.all()))
        .sorted(Comparator.comparingDouble((Fit fit) -> -penalised(fit)))
        .limit(most)
        .toList();
  }

  /** Two forms of one effect beside each other only where they change different things. */
  private static boolean apart(Hypothesis base, MotionForm form) {
    boolean lag = form.effect().equals("actuation-lag") && base.names(form.effect());
    boolean clocks = form.clocks() && base.names("actuation-latency");
    return !lag && !clocks;
  }

  private static double penalised(Fit fit) {
    return fit.score() - 2.0 * fit.hypothesis().values().length;
  }

  /** Drops what the others make needless; a form that stands for two comes in their place. */
  private HeldOut pruned(HeldOut with) {
    HeldOut best = with;
    for (MotionForm form : with.full().hypothesis().forms()) {
      Hypothesis less = best.full().hypothesis().without(form);
      HeldOut without = HeldOut.of(evidence, fitter.fit(less, fitter.all()));
      if (best.z(without) < KEPT_Z) {
        best = without;
      }
    }
    return merged(best);
  }

  private HeldOut merged(HeldOut best) {
    Hypothesis both = best.full().hypothesis();
    if (!both.names("speed-scale") || !both.names("turn-scale")) {
      return best;
    }
    Hypothesis neither =
        both.without(MotionForms.find("speed-scale").orElseThrow())
            .without(MotionForms.find("turn-scale").orElseThrow());
    MotionForm wheels = MotionForms.find("wheel-scale").orElseThrow();
    HeldOut one = HeldOut.of(evidence, fitter.fitWith(neither, wheels, fitter.all()));
    return best.z(one) < KEPT_Z ? one : best;
  }

  /** Tells whether each form has a parameter that is off by so much that it matters. */
  private static boolean matters(Hypothesis hypothesis) {
    for (MotionForm form : hypothesis.forms()) {
      double[] values = hypothesis.values(form);
      boolean one = false;
      for (int i = 0; i < values.length; i++) {
        MotionParameter parameter = form.parameters().get(i);
        one |= Math.abs(values[i] - parameter.neutral()) >= parameter.practical();
      }
      if (!one) {
        return false;
      }
    }
    return true;
  }

  private static double sum(HeldOut held) {
    double sum = 0;
    for (double score : held.blockScores()) {
      sum += score;
    }
    return sum;
  }

  /**
   * Returns how sure it is that a named form is needed to foretell blocks that were left out, all
   * forms that were tried counted; not that none but it would do.
   */
  double sure(HeldOut chosen, MotionForm named) {
    Hypothesis less = chosen.full().hypothesis().without(named);
    HeldOut without = HeldOut.of(evidence, fitter.fit(less, fitter.all()));
    return Chance.chosen(chosen.z(without), forms.size());
  }

  /** Returns names that would do in place of a named form as well as it does. */
  List<String> ties(HeldOut chosen, MotionForm named) {
    Hypothesis less = chosen.full().hypothesis().without(named);
    List<String> ties = new ArrayList<>();
    for (Fit fit : candidates(less, forms.size())) {
      List<MotionForm> with = fit.hypothesis().forms();
      String effect = with.get(with.size() - 1).effect();
      boolean other = !effect.equals(named.effect()) && !less.names(effect);
      if (other && fit.score() > chosen.full().score() - TIE && !ties.contains(effect)) {
        ties.add(effect);
      }
    }
    return ties;
  }
}
