package simbad.gap.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import simbad.definition.Effect;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.scene.SonarSpec;

/** What to do about each effect that is named: one sentence with its number. */
public final class Remedies {
  private Remedies() {}

  /**
   * Returns the effects that one could act upon, the named ones first: where the verdict names
   * effects these, and what the data cannot tell from the only one, with values that were fitted
   * with nothing beside it.
   *
   * @param diagnosis of a data set
   */
  public static List<EffectFinding> toActUpon(Diagnosis diagnosis) {
    if (!diagnosis.verdict().namesEffects()) {
      return List.of();
    }
    List<Effect> named = diagnosis.explanation();
    List<EffectFinding> found =
        new ArrayList<>(
            diagnosis.effects().stream().filter(one -> named.contains(one.effect())).toList());
    if (named.size() == 1) {
      List<Effect> ties = found.get(0).indistinguishableFrom();
      diagnosis.effects().stream()
          .filter(one -> ties.contains(one.effect()) && one.form().isPresent())
          .forEach(found::add);
    }
    return found;
  }

  /**
   * Returns the remedy of an effect.
   *
   * @param finding of the effect, with fitted values
   * @param sensor as the simulator believes it
   */
  public static String of(EffectFinding finding, SonarSpec sensor) {
    Map<String, Double> values =
        finding.parameters().stream()
            .collect(Collectors.toMap(FittedParameter::name, FittedParameter::value, (a, b) -> a));
    return Definitions.of(finding.effect()).remedy(new FittedValues(values, sensor));
  }
}
