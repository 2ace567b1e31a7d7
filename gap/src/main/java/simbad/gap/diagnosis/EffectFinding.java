package simbad.gap.diagnosis;

import java.util.List;
import java.util.Optional;
import simbad.definition.Effect;
import simbad.sonar.check.Checks;

/**
 * What a diagnosis found of one effect of the vocabulary.
 *
 * @param effect whose finding it is
 * @param probability that it is at work
 * @param form name of the form that fitted best; empty where none was fitted
 * @param parameters fitted, by name with unit, in the form's order; empty where none was fitted
 * @param indistinguishableFrom effects that these data cannot tell from it
 */
public record EffectFinding(
    Effect effect,
    double probability,
    Optional<String> form,
    List<FittedParameter> parameters,
    List<Effect> indistinguishableFrom) {
  /** Copies the lists. */
  public EffectFinding {
    Checks.number("probability", probability);
    parameters = List.copyOf(parameters);
    indistinguishableFrom = List.copyOf(indistinguishableFrom);
  }
}
