package simbad.gap.fit;

import java.util.List;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.MemoryChange;

/**
 * Fits a set-up to its reference and to a log together, while the log's effects stay as they are.
 */
public final class JointFitter extends Fitter {
  private final Fitter log;
  private final Hypothesis effects;

  /**
   * Creates a fitter.
   *
   * @param reference without calibration
   * @param log without calibration
   * @param effects at work in the log alone
   */
  public JointFitter(CalibratedLog reference, CalibratedLog log, Hypothesis effects) {
    super(reference, Fold.ALL);
    this.log = new Fitter(log, Fold.ALL);
    this.effects = effects;
  }

  /** Returns the log likelihood of a set-up: of the reference, and of the log with its effects. */
  @Override
  public double logLikelihood(Hypothesis setup) {
    Hypothesis both = unreplaced(setup);
    for (int i = 0; i < effects.forms().size(); i++) {
      both = both.and(effects.forms().get(i), effects.valuesOf(i));
    }
    return super.logLikelihood(setup) + log.logLikelihood(both);
  }

  /** A model remembers in one way of each kind: an effect's stands in the place of a set-up's. */
  private Hypothesis unreplaced(Hypothesis setup) {
    List<Change> ofEffects = effects.changes();
    Hypothesis rest = Hypothesis.NONE;
    for (int i = 0; i < setup.forms().size(); i++) {
      Change change = setup.forms().get(i).with(setup.valuesOf(i));
      boolean replaced =
          change instanceof MemoryChange
              && ofEffects.stream().anyMatch(effect -> effect.getClass() == change.getClass());
      if (!replaced) {
        rest = rest.and(setup.forms().get(i), setup.valuesOf(i));
      }
    }
    return rest;
  }
}
