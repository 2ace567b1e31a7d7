package simbad.motion.effect;

import simbad.motion.MotionChange;
import simbad.sonar.check.Checks;

/**
 * A form with its values.
 *
 * @param form of an effect
 * @param values one per parameter
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers, never compared.
public record FittedMotion(MotionForm form, double[] values) {
  /** Checks that all values are numbers. */
  public FittedMotion {
    Checks.numbers("values", values);
  }

  /** Returns the change. */
  public MotionChange change() {
    return form.change(values);
  }
}
