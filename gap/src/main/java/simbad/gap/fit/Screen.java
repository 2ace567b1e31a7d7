package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Collectors;
import simbad.definition.Effect;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;

/**
 * Fits every effect beside a hypothesis that stays as it is. Of an effect whose first form gains
 * nothing only those other forms are fitted that gain by their first guess, and what gains nothing
 * at first is not refined.
 */
public final class Screen {
  /** Less than this, in nats, is chance. */
  private static final double CHANCE_NATS = 1.5;

  /** Of a table: thresholds are held together, and many have no ping to follow. */
  private static final double THRESHOLD_NATS = 0.75;

  /** So many pings are enough to choose what is fitted to all of them. */
  private static final int ENOUGH_PINGS = 1000;

  /** So many starts at most are told apart by all pings. */
  private static final int ALIKE = 6;

  private static final int REFINED = 6;

  /** Forms of one effect that are so near each other are both refined before one is chosen. */
  private static final double CLOSE_NATS = 20;

  private static final int CLOSE = 2;
  private static final int FEW = 3;
  private static final int RESTARTS = 2;

  private final CalibratedLog given;
  private final Fit base;
  private final Clues clues;

  /** The pings by which forms are chosen; each stands for so many. */
  private final Fold some;

  private final int standsFor;
  private final double baseOfSome;

  /** Creates a screen for the forms beside a fit. */
  public Screen(CalibratedLog given, Fit base) {
    this.given = given;
    this.base = base;
    clues = new LogClues(given, base.hypothesis());
    standsFor = Math.max(1, given.log().size() / ENOUGH_PINGS);
    some = standsFor == 1 ? Fold.ALL : new Thinned(given.log().size(), standsFor);
    baseOfSome =
        standsFor == 1
            ? base.logLikelihood()
            : new Fitter(given, some).logLikelihood(base.hypothesis());
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
            .collect(Collectors.groupingBy(Form::effect, TreeMap::new, Collectors.toList()));
    Map<Effect, List<Fit>> rough = new TreeMap<>();
    byEffect.entrySet().parallelStream()
        .map(entry -> Map.entry(entry.getKey(), bestOf(entry.getValue())))
        .toList()
        .forEach(entry -> rough.put(entry.getKey(), entry.getValue()));
    Map<Effect, Fit> best = new TreeMap<>();
    rough.forEach((effect, fits) -> best.put(effect, fits.get(0)));
    rough.entrySet().stream()
        .filter(entry -> gain(entry.getValue().get(0)) > CHANCE_NATS)
        .sorted(Comparator.comparingDouble(entry -> -entry.getValue().get(0).logLikelihood()))
        .limit(REFINED)
        .flatMap(entry -> entry.getValue().stream())
        .toList()
        .parallelStream()
        .map(this::refined)
        .toList()
        .forEach(fit -> best.merge(added(fit).effect(), fit, Screen::better));
    return best;
  }

  private Fit refined(Fit rough) {
    int from = base.hypothesis().size();
    int size = rough.hypothesis().size() - from;
    if (added(rough).isTable()) {
      return rough;
    }
    Fitter fitter = new Fitter(given, Fold.ALL);
    Fit fit = fitter.settle(rough.hypothesis(), from, 20 + 20 * size, 0);
    // A simplex of many values flattens before it has arrived; a fresh one from beside goes on.
    for (int again = 0; again < RESTARTS && size > FEW; again++) {
      double before = fit.logLikelihood();
      fit = fitter.refine(fitter.sweep(fit, from).hypothesis(), from, 20 + 20 * size);
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

  /** The best form, and those that may turn out to be it. */
  private List<Fit> bestOf(List<Form> forms) {
    List<Begun> begun = forms.parallelStream().map(this::begun).toList();
    Fit first = approached(begun.get(0));
    boolean promising = gainOfSome(first) >= CHANCE_NATS;
    List<Fit> fits = new ArrayList<>(List.of(first));
    fits.addAll(
        begun.subList(1, begun.size()).parallelStream()
            .filter(other -> promising || gainOfSome(other.fit) >= CHANCE_NATS)
            .map(this::approached)
            .toList());
    fits.sort(Comparator.comparingDouble(fit -> -meritOfSome(fit)));
    double least = meritOfSome(fits.get(0)) - CLOSE_NATS;
    return fits.stream()
        .filter(fit -> meritOfSome(fit) > least)
        .limit(CLOSE)
        .map(this::ofAll)
        .sorted(Comparator.comparingDouble(fit -> -merit(fit)))
        .toList();
  }

  private Fit ofAll(Fit ofSome) {
    Hypothesis set = ofSome.hypothesis();
    return standsFor == 1 ? ofSome : new Fit(set, new Fitter(given, Fold.ALL).logLikelihood(set));
  }

  /** What a fit of some pings would gain of all of them. */
  private double gainOfSome(Fit ofSome) {
    return standsFor * (ofSome.logLikelihood() - baseOfSome);
  }

  private double meritOfSome(Fit ofSome) {
    return gainOfSome(ofSome) - cost(ofSome);
  }

  private static Fit better(Fit one, Fit other) {
    return merit(other) > merit(one) ? other : one;
  }

  /** Of two forms that fit alike the simpler one is taken. */
  private static double merit(Fit fit) {
    return fit.logLikelihood() - cost(fit);
  }

  private static double cost(Fit fit) {
    double each = fit.hypothesis().hasTable() ? THRESHOLD_NATS : CHANCE_NATS;
    return each * fit.hypothesis().size();
  }

  private double gain(Fit fit) {
    return fit.logLikelihood() - base.logLikelihood();
  }

  /**
   * The best of a form's starts.
   *
   * @param fitter that knows the others
   */
  private record Begun(Fit fit, Fitter fitter) {}

  private Begun begun(Form form) {
    Fitter fitter = new Fitter(given, some);
    List<Fit> starts =
        Definitions.of(form.effect()).starts(form, clues).stream()
            .map(values -> base.hypothesis().and(form, values))
            .map(start -> new Fit(start, fitter.logLikelihood(start)))
            .sorted(Comparator.comparingDouble(start -> -start.logLikelihood()))
            .toList();
    Fit best = starts.get(0);
    if (standsFor > 1 && gainOfSome(best) >= CHANCE_NATS) {
      best = toldApart(starts);
    }
    return new Begun(best, fitter);
  }

  /**
   * Of starts that some pings do not tell apart, the one that all pings find best. How long a
   * reading is held, say, is told by the few at which it ends, and a step that is missed is not
   * found later: between steps nothing changes.
   */
  private Fit toldApart(List<Fit> starts) {
    double least = starts.get(0).logLikelihood() - CHANCE_NATS;
    List<Fit> alike =
        starts.stream().filter(start -> start.logLikelihood() > least).limit(ALIKE).toList();
    return alike.size() == 1
        ? alike.get(0)
        : alike.stream()
            .max(Comparator.comparingDouble(start -> ofAll(start).logLikelihood()))
            .orElseThrow();
  }

  private Fit approached(Begun begun) {
    Form form = added(begun.fit);
    int most = 14 + 10 * form.parameters().size();
    return form.isTable()
        ? begun.fit
        : begun.fitter.approach(begun.fit.hypothesis(), base.hypothesis().size(), most);
  }
}
