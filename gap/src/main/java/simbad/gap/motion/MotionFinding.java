package simbad.gap.motion;

import java.util.List;
import simbad.gap.diagnosis.Interval;

/**
 * An effect that is at work.
 *
 * @param effect its name in the vocabulary
 * @param form its own name; that of the effect where only the scatter changes
 * @param probability that it is needed to foretell blocks that were left out, in [0, 1]; not that
 *     none but it would do
 * @param parameters with values and intervals
 * @param ties names that these data cannot tell from it
 * @param remedy what to do about it
 */
public record MotionFinding(
    String effect,
    String form,
    double probability,
    List<Parameter> parameters,
    List<String> ties,
    String remedy) {
  /** Copies the lists. */
  public MotionFinding {
    parameters = List.copyOf(parameters);
    ties = List.copyOf(ties);
  }

  /**
   * A fitted number.
   *
   * @param name with its unit
   * @param value fitted to all blocks
   * @param ci95 by leaving out a tenth of the log at a time, within what is allowed
   * @param atBound whether it stands at the end of what was allowed
   */
  public record Parameter(String name, double value, Interval ci95, boolean atBound) {}
}
