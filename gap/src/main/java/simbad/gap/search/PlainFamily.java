package simbad.gap.search;

import java.util.List;
import java.util.Objects;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Trait;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Screen;
import simbad.gap.score.Probabilities;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;

/**
 * The plain causes, which are the commonest: a scale (a wrong constant, a wrong unit), an offset
 * (where the tape began), the cone, the reach and the noise. They are always tried together, since
 * none of them alone need gain much beside another one that is at work.
 */
final class PlainFamily {
  /** What may stand beside the law of the ranges. */
  static final Set<Effect> BESIDE_THE_LAW = Definitions.with(Trait.BESIDE_THE_LAW);

  /**
   * Where things are put in place by hand, each placement is a little off, and what can be moved or
   * bent in a scene soaks that up: these have to gain so much more there than anything else ({@link
   * Probabilities#UNSEEN}).
   */
  static final Set<Effect> SOAK_UP_PLACEMENTS = Definitions.with(Trait.SOAKS_UP_PLACEMENTS);

  private static final int STEPS_FAR = 80;
  private static final int STEPS_NEAR = 60;

  private final CalibratedLog given;
  private final List<Form> forms;

  /**
   * Creates the family for a log.
   *
   * @param given the log
   * @param forms that are looked for
   */
  PlainFamily(CalibratedLog given, List<Form> forms) {
    this.given = given;
    this.forms = forms;
  }

  /** Fits a scale and an offset together; of less where one of them is not looked for. */
  Fit law() {
    Fit fit = new Fitter(given, Fold.ALL).refine(Hypothesis.NONE, 0);
    for (Effect effect : Definitions.with(Trait.LAW_OF_RANGES)) {
      fit = with(effect, fit);
    }
    return joint(fit);
  }

  private Fit with(Effect effect, Fit base) {
    List<Form> own = forms.stream().filter(form -> form.effect() == effect).toList();
    return own.isEmpty()
        ? base
        : Objects.requireNonNull(new Screen(given, base).all(own).get(effect));
  }

  private Fit joint(Fit fit) {
    Fitter fitter = new Fitter(given, Fold.ALL);
    return fitter.settle(fit.hypothesis(), 0, STEPS_FAR, STEPS_NEAR);
  }
}
