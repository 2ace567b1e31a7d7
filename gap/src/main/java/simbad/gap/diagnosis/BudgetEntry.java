package simbad.gap.diagnosis;

import simbad.sonar.check.Checks;

/**
 * One part of how the gap before is made up; all parts of a budget add up to it.
 *
 * @param what an effect's name, {@link #REST} for what no named effect explains, or {@link #FLOOR}
 *     for the scatter that a right model would leave
 * @param cm of the gap before, centimetres; below 0 for an effect beside which another one would
 *     shrink the gap further
 * @param ci95 where it lies 19 times of 20 in logs like this one, by blocks drawn anew
 */
public record BudgetEntry(String what, double cm, Interval ci95) {
  /** Refuses what is no number. */
  public BudgetEntry {
    Checks.number("cm", cm);
  }

  /** What no named effect explains. */
  public static final String REST = "rest";

  /** The scatter that a right model would leave. */
  public static final String FLOOR = "floor";
}
