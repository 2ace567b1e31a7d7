package simbad.gap.calibrate;

import java.util.List;
import simbad.gap.fit.Hypothesis;

/**
 * A level law as a reference shows it.
 *
 * @param setup the forms of the law, of each obstacle's strength and of the ranges' tails
 * @param values that hang on no obstacle, with their deviations
 * @param trials what they were fitted on: pings times obstacles that they tried
 * @param priorCost how improbable the values were before: natural logarithm, at least 0
 */
public record LevelCalibration(Hypothesis setup, List<Named> values, int trials, double priorCost) {
  /** Copies the list. */
  public LevelCalibration {
    values = List.copyOf(values);
  }
}
