package simbad.sonar.effect;

import java.util.Locale;
import java.util.Map;
import simbad.sonar.scene.SonarSpec;

/**
 * What was fitted of an effect, for its remedy.
 *
 * @param byName values by the names of the parameters, in the units of files
 * @param sensor as the simulator believes it
 */
public record FittedValues(Map<String, Double> byName, SonarSpec sensor) {
  /** Copies the map. */
  public FittedValues {
    byName = Map.copyOf(byName);
  }

  /** Tells whether the fitted form has a parameter. */
  public boolean has(String name) {
    return byName.containsKey(name);
  }

  /** Returns the value of a parameter; NaN where the fitted form has no such one. */
  public double value(String name) {
    return byName.getOrDefault(name, Double.NaN);
  }

  /** Returns a text with numbers in it, with a decimal point everywhere. */
  public static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
