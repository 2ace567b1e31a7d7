package simbad.gap.diagnosis;

import java.util.OptionalDouble;
import simbad.definition.Effect;

/**
 * An effect that these data could not have shown.
 *
 * @param effect by name
 * @param parameter whose size is meant, with its unit
 * @param leastSize the least departure from neutral that would have shown; empty where none would
 */
public record Undetectable(Effect effect, String parameter, OptionalDouble leastSize) {}
