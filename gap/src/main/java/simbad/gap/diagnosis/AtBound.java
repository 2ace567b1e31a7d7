package simbad.gap.diagnosis;

import simbad.definition.Effect;
import simbad.sonar.check.Checks;

/**
 * A fitted parameter that stands at an end of what was searched: a better value may lie beyond it,
 * so it explains nothing.
 *
 * @param effect whose parameter it is
 * @param parameter its name, with its unit
 * @param value fitted
 * @param allowed the values that were searched
 */
public record AtBound(Effect effect, String parameter, double value, Interval allowed) {
  /** Refuses what is no number. */
  public AtBound {
    Checks.number("value", value);
  }
}
