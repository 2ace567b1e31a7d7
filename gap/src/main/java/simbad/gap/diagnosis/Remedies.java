package simbad.gap.diagnosis;

import java.util.Map;
import java.util.stream.Collectors;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.scene.SonarSpec;

/** What to do about each effect that is named: one sentence with its number. */
public final class Remedies {
  private Remedies() {}

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
