package simbad.sonar.effect;

import java.util.Arrays;
import java.util.List;

/**
 * A parameter of a form of an effect.
 *
 * @param name with its unit, as in files: {@code offset_m}, {@code turn_deg}
 * @param neutral at which the form is the nominal model; may be infinite
 * @param low least value that makes sense
 * @param high greatest value that makes sense
 * @param tries values from which a search may start, all in [low, high]
 */
public record Parameter(String name, double neutral, double low, double high, List<Double> tries) {
  /** Checks the interval and copies the tries. */
  public Parameter {
    tries = List.copyOf(tries);
    for (double value : tries) {
      if (!(value >= low && value <= high)) {
        throw new IllegalArgumentException(
            name + " = " + value + " is not in [" + low + ", " + high + "]");
      }
    }
  }

  static Parameter of(String name, double neutral, double low, double high, double... tries) {
    return new Parameter(name, neutral, low, high, Arrays.stream(tries).boxed().toList());
  }

  /** Tells whether it may have a value: a sensible one, or the neutral one. */
  public boolean permits(double value) {
    return (value >= low && value <= high) || value == neutral;
  }

  /** Returns in words which values it may have. */
  public String domain() {
    boolean inside = neutral >= low && neutral <= high;
    return "in [" + low + ", " + high + "]" + (inside ? "" : " or " + neutral);
  }

  /** Returns the nearest value that makes sense. */
  public double clamp(double value) {
    return Math.max(low, Math.min(high, value));
  }
}
