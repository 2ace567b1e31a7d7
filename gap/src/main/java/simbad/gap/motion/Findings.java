package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import simbad.gap.diagnosis.Interval;
import simbad.gap.score.IntervalWidths;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.effect.MotionParameter;

/** What the weighed sets say of each name of the vocabulary. */
final class Findings {
  private final Odds odds;
  private final Map<String, Double> probabilities;

  Findings(Odds odds) {
    this.odds = odds;
    probabilities = odds.ofEffects();
  }

  /** Returns the effects of the most probable set, with their remedies. */
  List<MotionFinding> named() {
    ScoredMotion best = odds.best();
    return best.hypothesis().effects().stream()
        .map(effect -> finding(effect, best, odds.tiesOf(effect), true))
        .sorted(Comparator.comparingDouble(one -> -one.probability()))
        .toList();
  }

  /** Returns every other name of the vocabulary that changes the mean. */
  List<MotionFinding> others(List<MotionFinding> named) {
    List<String> taken = named.stream().map(MotionFinding::effect).toList();
    List<MotionFinding> others = new ArrayList<>();
    for (String effect : MotionForms.vocabulary()) {
      if (!taken.contains(effect)) {
        ScoredMotion set = odds.bestWith(effect);
        others.add(
            set.hypothesis().names(effect)
                ? finding(effect, set, tiesOf(effect, named), false)
                : new MotionFinding(effect, "", 0, List.of(), List.of(), ""));
      }
    }
    others.sort(Comparator.comparingDouble(one -> -one.probability()));
    return others;
  }

  private static List<String> tiesOf(String effect, List<MotionFinding> named) {
    return named.stream()
        .filter(one -> one.ties().contains(effect))
        .map(MotionFinding::effect)
        .toList();
  }

  private MotionFinding finding(
      String effect, ScoredMotion set, List<String> ties, boolean concluded) {
    MotionHypothesis hypothesis = set.hypothesis();
    double[] errors = set.slopes().standardErrors();
    List<MotionFinding.Parameter> parameters = new ArrayList<>();
    List<String> names = new ArrayList<>();
    List<String> remedies = new ArrayList<>();
    int at = 0;
    for (MotionForm form : hypothesis.forms()) {
      int size = form.parameters().size();
      double[] values = Arrays.copyOfRange(hypothesis.values(), at, at + size);
      for (int i = 0; i < size && form.effect().equals(effect); i++) {
        if (Double.isFinite(values[i])) {
          parameters.add(parameter(form.parameters().get(i), values[i], errors[at + i]));
        }
      }
      if (form.effect().equals(effect)) {
        names.add(form.form());
        remedies.add(remedy(form, values));
      }
      at += size;
    }
    double probability = Math.min(1, probabilities.getOrDefault(effect, 0.0));
    return new MotionFinding(
        effect,
        String.join(" + ", names),
        probability,
        parameters,
        ties,
        concluded ? String.join("; ", remedies) : "");
  }

  /** The sentence of the form, unless it is about a value that stays as it was. */
  private static String remedy(MotionForm form, double[] values) {
    for (int i = 0; i < values.length; i++) {
      MotionParameter parameter = form.parameters().get(i);
      if (values[i] != parameter.neutral()) {
        String value = String.format(Locale.ROOT, "%.4g", values[i]);
        return i == 0
            ? String.format(Locale.ROOT, form.remedy(), value)
            : "give the model " + parameter.name() + " = " + value;
      }
    }
    return "";
  }

  /** Where motion jumps as a value changes, or shows nothing of it, nothing bounds it. */
  private static Interval ci95(MotionParameter parameter, double value, double error) {
    double half = NormalChance.NORMAL_95 * IntervalWidths.own().motion() * error;
    return error > 0
        ? new Interval(parameter.within(value - half), parameter.within(value + half))
        : new Interval(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
  }

  private static MotionFinding.Parameter parameter(
      MotionParameter parameter, double value, double error) {
    return new MotionFinding.Parameter(
        parameter.name(),
        value,
        ci95(parameter, value, error),
        new Interval(parameter.low(), parameter.high()),
        parameter.isAtBound(value));
  }
}
