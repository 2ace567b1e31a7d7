package simbad.gap.diagnosis;

import java.util.OptionalDouble;
import simbad.definition.Effect;
import simbad.sonar.check.Checks;

/**
 * An effect that these data could not have shown.
 *
 * @param effect by name
 * @param parameter whose size is meant, with its unit
 * @param leastSize the least departure from neutral that would have shown; empty where none would
 */
public record Undetectable(Effect effect, String parameter, OptionalDouble leastSize) {
  /** Refuses what is no number. */
  public Undetectable {
    Checks.number("leastSize", leastSize);
  }
}
