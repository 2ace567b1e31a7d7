package simbad.gap.score;

import com.fasterxml.jackson.databind.JsonNode;
import simbad.gap.constants.FittedConstants;
import simbad.sonar.check.Checks;
import simbad.sonar.scene.SensorLaw;

/**
 * How many times as wide the intervals of values are as the likelihood alone says, so that of those
 * narrowed to 90 % nine in ten hold the true value: models are all a little wrong.
 * benchmarks/fit-intervals fits them anew.
 *
 * @param threshold under the threshold law
 * @param level under the level law
 * @param motion of effects of motion
 */
public record IntervalWidths(double threshold, double level, double motion) {
  /** Of the file. */
  public static final String FORMAT = "simbad-intervals/1";

  private static final IntervalWidths OWN = of(FittedConstants.of(IntervalWidths.class));

  /** Refuses what is not positive. */
  public IntervalWidths {
    Checks.positive("threshold", threshold);
    Checks.positive("level", level);
    Checks.positive("motion", motion);
  }

  /** Returns those that the diagnosis uses. */
  public static IntervalWidths own() {
    return OWN;
  }

  /**
   * Reads widths.
   *
   * @param root of a file of format "simbad-intervals/1"
   * @throws IllegalArgumentException if a field is missing or no number
   */
  public static IntervalWidths of(JsonNode root) {
    FittedConstants.check(root, FORMAT);
    return new IntervalWidths(
        FittedConstants.number(root, "threshold"),
        FittedConstants.number(root, "level"),
        FittedConstants.number(root, "motion"));
  }

  /** Returns that under a law. */
  public double under(SensorLaw.Model law) {
    return law == SensorLaw.Model.LEVEL ? level : threshold;
  }
}
