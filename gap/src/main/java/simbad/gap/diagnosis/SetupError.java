package simbad.gap.diagnosis;

import simbad.sonar.check.Checks;

/**
 * How far a calibrated set-up is off on rows of its reference that it was not fitted on.
 *
 * @param rows that were held out
 * @param gapCm their mean gap
 * @param expectedCm what it would be if the calibrated set-up were right
 * @param echoes by how much more sums of echoes over blocks vary than by chance; at least 1
 * @param ranges the same of ranges; at least 1
 * @param misfit mean of its greatest misfits; some 3 by chance
 */
public record SetupError(
    int rows, double gapCm, double expectedCm, double echoes, double ranges, double misfit) {
  /** Refuses what is no number. */
  public SetupError {
    Checks.number("gapCm", gapCm);
    Checks.number("expectedCm", expectedCm);
    Checks.number("echoes", echoes);
    Checks.number("ranges", ranges);
    Checks.number("misfit", misfit);
  }
}
