package simbad.gap;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.FittedParameter;
import simbad.gap.diagnosis.Interval;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Placements;
import simbad.gap.score.HeldOut.Scored;
import simbad.gap.score.IntervalWidths;
import simbad.gap.score.PlacementScatter;
import simbad.gap.score.Uncertainty;
import simbad.gap.search.Weighed;
import simbad.gap.unexplained.Constants;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.scene.SensorLaw;

/**
 * What is said of each effect.
 *
 * @param given the log
 * @param sets that were fitted
 * @param weighed the set that is concluded upon
 * @param unknown probability that something without a name is at work
 * @param law of hearing that was taken
 * @param clumping by which readings hang together
 * @param isSure whether only what is sure beside something else is named
 */
record EffectFindings(
    CalibratedLog given,
    List<Scored> sets,
    Weighed weighed,
    double unknown,
    SensorLaw.Model law,
    double clumping,
    boolean isSure) {
  private static final double NORMAL_95 = 1.96;

  /** All of them, the most probable first. */
  List<EffectFinding> all() {
    Map<Effect, Double> probability = new TreeMap<>();
    weighed.probabilities().ofEffects().forEach((e, p) -> probability.put(e, stated(p)));
    Hypothesis best = weighed.taken().hypothesis();
    if (isSure) {
      best.effects().forEach(effect -> share(effect, probability));
    }
    double[] deviations = deviations(best);
    List<EffectFinding> findings = new ArrayList<>();
    for (Effect effect : Definitions.effects()) {
      findings.add(
          best.has(effect)
              ? named(effect, best, deviations, probability.getOrDefault(effect, 0.0))
              : other(effect, probability.getOrDefault(effect, 0.0)));
    }
    findings.sort(Comparator.comparingDouble(finding -> -finding.probability()));
    return findings;
  }

  /** What is sure shares it with what the log cannot tell from it as it was taken. */
  private void share(Effect effect, Map<Effect, Double> probability) {
    List<Effect> ties = ties(effect);
    double each = namedRightly() / (1 + ties.size());
    probability.put(effect, each);
    ties.forEach(tied -> probability.put(tied, each));
  }

  /** Beside a rest only what has no rival is sure. */
  private List<Effect> ties(Effect effect) {
    double nats = isSure ? Double.NEGATIVE_INFINITY : Diagnoser.TIE_NATS * clumping;
    return weighed.tiesOf(effect, nats);
  }

  private double namedRightly() {
    return Constants.own().under(law).namedRightly();
  }

  /** That it is at work, and nothing without a name is what it stands in for. */
  private double stated(double amongTheNamed) {
    return namedRightly() * (1 - unknown) * amongTheNamed;
  }

  private double[] deviations(Hypothesis set) {
    double placed = PlacementScatter.statedClumping(given, new Placements(given.log()));
    double wider = IntervalWidths.own().under(law);
    double[] deviations = new Uncertainty(given, Math.max(clumping, placed)).deviations(set);
    return Arrays.stream(deviations).map(each -> wider * each).toArray();
  }

  /**
   * Where things are put in place along a tape, nobody knows where the tape began: the interval of
   * a scale holds what it is beside an offset as well, though the offset is too small to be named,
   * and the other way round.
   */
  private List<FittedParameter> leaningOn(Effect effect, List<FittedParameter> own) {
    Set<Effect> law = Definitions.with(Trait.LAW_OF_RANGES);
    Hypothesis best = weighed.taken().hypothesis();
    if (!law.contains(effect) || !new Placements(given.log()).areRepeated()) {
      return own;
    }
    Set<Effect> both = new TreeSet<>(best.effects());
    both.addAll(law);
    return sets.stream()
        .map(Scored::hypothesis)
        .filter(set -> set.size() > best.size() && Set.copyOf(set.effects()).equals(both))
        .findFirst()
        .map(set -> spanned(own, set, effect))
        .orElse(own);
  }

  private List<FittedParameter> spanned(List<FittedParameter> own, Hypothesis set, Effect effect) {
    int at = set.effects().indexOf(effect);
    int from = set.forms().subList(0, at).stream().mapToInt(f -> f.parameters().size()).sum();
    Form form = set.forms().get(at);
    int size = form.parameters().size();
    double[] deviations = Arrays.copyOfRange(deviations(set), from, from + size);
    List<FittedParameter> other = fitted(form, set.valuesOf(at), deviations);
    List<FittedParameter> spanned = new ArrayList<>();
    for (FittedParameter one : own) {
      spanned.add(
          other.stream()
              .filter(like -> like.name().equals(one.name()))
              .map(like -> one.with(one.ci95().hull(like.ci95())))
              .findFirst()
              .orElse(one));
    }
    return spanned;
  }

  private static double[] infinite(int size) {
    double[] all = new double[size];
    Arrays.fill(all, Double.POSITIVE_INFINITY);
    return all;
  }

  private EffectFinding named(
      Effect effect, Hypothesis best, double[] deviations, double probability) {
    int at = best.effects().indexOf(effect);
    int from = 0;
    for (int i = 0; i < at; i++) {
      from += best.forms().get(i).parameters().size();
    }
    Form form = best.forms().get(at);
    double[] own = Arrays.copyOfRange(deviations, from, from + form.parameters().size());
    return new EffectFinding(
        effect,
        probability,
        Optional.of(form.name()),
        leaningOn(effect, fitted(form, best.valuesOf(at), own)),
        ties(effect));
  }

  /** Of an effect that is not in the explanation: its values when it is fitted alone. */
  private EffectFinding other(Effect effect, double probability) {
    Optional<Hypothesis> alone =
        sets.stream()
            .map(Scored::hypothesis)
            .filter(set -> set.effects().equals(List.of(effect)))
            .findFirst();
    List<Effect> tied =
        weighed.taken().hypothesis().effects().stream()
            .filter(in -> ties(in).contains(effect))
            .toList();
    return new EffectFinding(
        effect,
        probability,
        alone.map(set -> set.forms().get(0).name()),
        alone
            .map(set -> fitted(set.forms().get(0), set.values(), infinite(set.size())))
            .orElse(List.of()),
        tied);
  }

  private static List<FittedParameter> fitted(Form form, double[] values, double[] deviations) {
    List<FittedParameter> parameters = new ArrayList<>();
    for (int i = 0; i < values.length; i++) {
      Parameter parameter = form.parameters().get(i);
      double half = NORMAL_95 * deviations[i];
      // No further than the values that there are; beyond all bounds stays beyond.
      Interval ci95 =
          Double.isInfinite(half)
              ? new Interval(-half, half)
              : new Interval(parameter.clamp(values[i] - half), parameter.clamp(values[i] + half));
      parameters.add(new FittedParameter(parameter.name(), values[i], ci95));
    }
    return parameters;
  }
}
