package simbad.gap.calibrate;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Form;
import simbad.sonar.scene.SensingSetup;

/**
 * Fits what a set-up is off by to its reference: what is worth it, and thresholds by waves whose
 * spread the reference decides, by the marginal likelihood (MacKay 1992).
 */
final class Calibrator {
  private static final double WORTH_NATS = 4;
  private static final int ROUNDS = 3;

  /** Thresholds are off by a few per cent at most. */
  private static final double[] SPREADS = {0.003, 0.006, 0.01, 0.015, 0.02, 0.03, 0.05};

  private final Fitter fitter;
  private final List<Form> forms;
  private final List<Form> waves;
  private double variance;

  /**
   * Creates a calibrator.
   *
   * @param fitter of the reference, alone or with a log
   * @param setup as it is believed to be
   */
  Calibrator(Fitter fitter, SensingSetup setup) {
    this.fitter = fitter;
    forms = SetupForms.all(setup);
    waves = forms.stream().filter(form -> form.name().startsWith("threshold")).toList();
  }

  Hypothesis fit() {
    Hypothesis best = Hypothesis.NONE;
    for (Form form : forms) {
      if (!waves.contains(form)) {
        best = tried(best, form);
      }
    }
    return again(best, ROUNDS);
  }

  /** Fits a set-up that is known roughly once more, forms that it lacks included. */
  Hypothesis again(Hypothesis known) {
    Hypothesis best = known;
    for (Form form : forms) {
      if (!waves.contains(form) && !best.forms().contains(form)) {
        best = tried(best, form);
      }
    }
    return again(best, 1);
  }

  private Hypothesis again(Hypothesis known, int rounds) {
    Hypothesis best = known;
    for (int round = 0; round < rounds; round++) {
      best = waved(best);
      best = refined(best);
    }
    return best;
  }

  /** Returns the likelihood of a set-up less what its waves cost by their prior. */
  double given(Hypothesis setup) {
    double cost = 0;
    for (int i = 0; i < setup.forms().size(); i++) {
      if (variance > 0 && waves.contains(setup.forms().get(i))) {
        for (double wave : setup.valuesOf(i)) {
          cost += wave * wave / (2 * variance);
        }
      }
    }
    return fitter.logLikelihood(setup) - cost;
  }

  private Hypothesis tried(Hypothesis base, Form form) {
    Fit fit =
        Stream.of(start(form, true), start(form, false))
            .map(start -> base.and(form, start))
            .map(start -> fitter.refine(start, base.size(), 30 + 20 * form.parameters().size()))
            .max(Comparator.comparingDouble(Fit::logLikelihood))
            .orElseThrow();
    return fit.logLikelihood() - fitter.logLikelihood(base) > WORTH_NATS ? fit.hypothesis() : base;
  }

  private static double[] start(Form form, boolean small) {
    return form.parameters().stream()
        .mapToDouble(each -> each.tries().get(small ? 0 : each.tries().size() - 1))
        .toArray();
  }

  private Hypothesis waved(Hypothesis base) {
    List<Waves.Lie> lies = waves.stream().map(form -> new Waves(fitter, form).lie(base)).toList();
    double most = 0;
    variance = 0;
    for (double spread : SPREADS) {
      double worth = lies.stream().mapToDouble(lie -> lie.worth(spread * spread)).sum();
      if (worth > most) {
        most = worth;
        variance = spread * spread;
      }
    }
    if (variance == 0) {
      return without(base);
    }
    Hypothesis moved = base;
    for (int i = 0; i < waves.size(); i++) {
      double[] prior = new double[waves.get(i).parameters().size()];
      Arrays.fill(prior, variance);
      moved = new Waves(fitter, waves.get(i)).moved(moved, prior);
    }
    return moved;
  }

  private Hypothesis without(Hypothesis base) {
    Hypothesis rest = Hypothesis.NONE;
    for (int i = 0; i < base.forms().size(); i++) {
      if (!waves.contains(base.forms().get(i))) {
        rest = rest.and(base.forms().get(i), base.valuesOf(i));
      }
    }
    return rest;
  }

  /** The rest again, now that the thresholds are known better. */
  private Hypothesis refined(Hypothesis best) {
    Hypothesis rest = without(best);
    Hypothesis all = Hypothesis.NONE;
    for (int i = 0; i < best.forms().size(); i++) {
      if (waves.contains(best.forms().get(i))) {
        all = all.and(best.forms().get(i), best.valuesOf(i));
      }
    }
    int waved = all.size();
    for (int i = 0; i < rest.forms().size(); i++) {
      all = all.and(rest.forms().get(i), rest.valuesOf(i));
    }
    return rest.size() == 0 ? best : fitter.refine(all, waved, 30 + 25 * rest.size()).hypothesis();
  }
}
