package simbad.gap.fit;

import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;

/**
 * Fits every effect beside a hypothesis that stays as it is. Of an effect whose first form gains
 * nothing only those other forms are fitted that gain by their first guess, and what gains nothing
 * at first is not refined.
 */
public final class Screen {
  /** Less than this, in nats, is chance. */
  private static final double CHANCE_NATS = 1.5;

  private static final int REFINED = 6;
  private static final int FEW = 3;
  private static final int RESTARTS = 2;

  private final Evidence evidence;
  private final Fit base;
  private final Starts starts;

  /** Creates a screen for the forms beside a fit. */
  public Screen(Evidence evidence, Fit base) {
    this.evidence = evidence;
    this.base = base;
    starts = new Starts(new Clues(evidence, base.hypothesis()));
  }

  /**
   * Fits the forms of all effects that the base does not have: all of them roughly, the best few
   * well.
   *
   * @param forms grouped by effect or not
   * @return the best of each effect
   */
  public Map<Effect, Fit> all(List<Form> forms) {
    Map<Effect, List<Form>> byEffect =
        forms.stream()
            .filter(form -> !base.hypothesis().has(form.effect()))
            .collect(Collectors.groupingBy(Form::effect));
    Map<Effect, Fit> best = new EnumMap<>(Effect.class);
    byEffect.entrySet().parallelStream()
        .map(entry -> Map.entry(entry.getKey(), bestOf(entry.getValue())))
        .toList()
        .forEach(entry -> best.put(entry.getKey(), entry.getValue()));
    best.entrySet().stream()
        .filter(entry -> gain(entry.getValue()) > CHANCE_NATS)
        .sorted(Comparator.comparingDouble(entry -> -entry.getValue().logLikelihood()))
        .limit(REFINED)
        .toList()
        .parallelStream()
        .map(entry -> Map.entry(entry.getKey(), refined(entry.getValue())))
        .toList()
        .forEach(entry -> best.put(entry.getKey(), entry.getValue()));
    return best;
  }

  private Fit refined(Fit rough) {
    int from = base.hypothesis().size();
    int size = rough.hypothesis().size() - from;
    if (added(rough).isTable()) {
      return rough;
    }
    Fitter fitter = new Fitter(evidence, Fold.ALL);
    Fit fit = fitter.refine(rough.hypothesis(), from, 20 + 20 * size);
    // A simplex of many values flattens before it has arrived; a fresh one goes on.
    for (int again = 0; again < RESTARTS && size > FEW; again++) {
      double before = fit.logLikelihood();
      fit = fitter.refine(fit.hypothesis(), from, 20 + 20 * size);
      if (fit.logLikelihood() - before < CHANCE_NATS) {
        break;
      }
    }
    return fit;
  }

  /** The form that is fitted beside the base. */
  private static Form added(Fit fit) {
    List<Form> all = fit.hypothesis().forms();
    return all.get(all.size() - 1);
  }

  private Fit bestOf(List<Form> forms) {
    Fit first = approached(begun(forms.get(0)));
    boolean gains = gain(first) >= CHANCE_NATS;
    return forms.stream()
        .skip(1)
        .map(this::begun)
        .filter(begun -> gains || gain(begun) >= CHANCE_NATS)
        .map(this::approached)
        .reduce(first, (a, b) -> merit(b) > merit(a) ? b : a);
  }

  /** Of two forms that fit alike the simpler one is taken. */
  private static double merit(Fit fit) {
    return fit.logLikelihood() - CHANCE_NATS * fit.hypothesis().size();
  }

  private double gain(Fit fit) {
    return fit.logLikelihood() - base.logLikelihood();
  }

  /** The best of a form's starts. */
  private Fit begun(Form form) {
    Fitter fitter = new Fitter(evidence, Fold.ALL);
    return starts.of(form).stream()
        .map(values -> base.hypothesis().and(form, values))
        .map(start -> new Fit(start, fitter.logLikelihood(start)))
        .max(Comparator.comparingDouble(Fit::logLikelihood))
        .orElseThrow();
  }

  private Fit approached(Fit begun) {
    Form form = added(begun);
    return form.isTable()
        ? begun
        : new Fitter(evidence, Fold.ALL)
            .approach(
                begun.hypothesis(), base.hypothesis().size(), 14 + 10 * form.parameters().size());
  }
}
