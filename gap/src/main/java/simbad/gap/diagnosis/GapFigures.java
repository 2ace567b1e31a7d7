package simbad.gap.diagnosis;

import simbad.sonar.check.Checks;

/**
 * How large the gap is on rows that the fit never saw, and how far it shrinks.
 *
 * @param rowsHeldOut number of those rows
 * @param beforeCm gap of the simulator as it is, centimetres
 * @param afterCm gap of the diagnosed model, centimetres
 * @param floorCm gap that the diagnosed model expects of itself from scatter, centimetres
 * @param shrink 1 - after / before, a fraction; 0 where there is no gap before
 * @param shrinkCi95 where the shrinkage of another log from the same set-up lies 19 times of 20
 */
public record GapFigures(
    int rowsHeldOut,
    double beforeCm,
    double afterCm,
    double floorCm,
    double shrink,
    Interval shrinkCi95) {
  /** Refuses what is no number. */
  public GapFigures {
    Checks.number("beforeCm", beforeCm);
    Checks.number("afterCm", afterCm);
    Checks.number("floorCm", floorCm);
    Checks.number("shrink", shrink);
  }
}
