package simbad.gap.motion;

import java.util.List;
import simbad.gap.diagnosis.Interval;
import simbad.sonar.check.Checks;

/**
 * An effect that is at work, or might be.
 *
 * @param effect its name in the vocabulary
 * @param form its own name; that of the effect where only the scatter changes; empty where nothing
 *     was fitted
 * @param probability that it is at work, in [0, 1]
 * @param parameters with values and intervals
 * @param ties names that these data cannot tell from it
 * @param remedy what to do about it; empty where it is not concluded to be at work
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
    Checks.number("probability", probability);
    parameters = List.copyOf(parameters);
    ties = List.copyOf(ties);
  }

  /** Returns the same, no more probable than given. */
  MotionFinding atMost(double most) {
    return new MotionFinding(effect, form, Math.min(probability, most), parameters, ties, remedy);
  }

  /** Returns the same, less probable by a factor. */
  MotionFinding times(double share) {
    return new MotionFinding(effect, form, share * probability, parameters, ties, remedy);
  }

  /** Returns the same with another remedy. */
  MotionFinding with(String other) {
    return new MotionFinding(effect, form, probability, parameters, ties, other);
  }

  /**
   * A fitted number.
   *
   * @param name with its unit
   * @param value fitted to all blocks
   * @param ci95 from how far blocks of the log pull apart, within what is allowed; without ends
   *     where motion jumps as the value changes, or shows nothing of it
   * @param allowed what was searched
   * @param atBound whether it stands at the end of what was allowed
   */
  public record Parameter(
      String name, double value, Interval ci95, Interval allowed, boolean atBound) {
    /** Refuses what is no number. */
    public Parameter {
      Checks.number("value", value);
    }
  }
}
