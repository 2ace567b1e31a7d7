package simbad.gap.score;

import simbad.gap.fit.Hypothesis;
import simbad.sonar.check.Checks;

/**
 * A hypothesis with its evidence.
 *
 * @param hypothesis with the values that fit the whole log best
 * @param inSample log likelihood of the whole log, natural
 * @param heldOut log likelihood of each half of the blocks under values fitted on the other half
 */
public record Scored(Hypothesis hypothesis, double inSample, double heldOut) {
  /** Refuses what is no number. */
  public Scored {
    Checks.number("inSample", inSample);
    Checks.number("heldOut", heldOut);
  }
}
