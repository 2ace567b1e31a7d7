package simbad.gap.calibrate.level;

import java.util.List;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.check.Checks;

/**
 * A level law as a reference shows it.
 *
 * @param setup the forms of the law, of each obstacle's strength and of the ranges' tails
 * @param values that depend on no obstacle, with their deviations
 * @param trials what they were fitted on: pings times obstacles that they tried
 * @param priorCost how improbable the values were before: natural logarithm, at least 0
 * @param known of the values
 */
public record LevelCalibration(
    Hypothesis setup, List<Named> values, int trials, double priorCost, Leeway.Known known) {
  /** Copies the list. */
  public LevelCalibration {
    Checks.number("priorCost", priorCost);
    values = List.copyOf(values);
  }

  /**
   * Returns how far the reference leaves the set-up open.
   *
   * @param excessDb by how much levels are off at a distance, beyond what the fit knows of itself
   * @param rangeM the same of ranges, metres
   */
  public Leeway leeway(double excessDb, double rangeM) {
    return Leeway.of(known, excessDb, rangeM);
  }
}
