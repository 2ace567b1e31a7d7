package simbad.sonar.effect;

import java.util.List;

/**
 * One functional form of an effect: its parameters in the units of files, and the change that they
 * make.
 *
 * @param effect that it is a form of
 * @param name of the form among the forms of its effect
 * @param parameters in the order of the values that {@link #with} takes
 * @param maker of the change
 */
public record Form(Effect effect, String name, List<Parameter> parameters, Maker maker) {
  /** Copies the parameters. */
  public Form {
    parameters = List.copyOf(parameters);
  }

  /** Makes a change of parameter values. */
  @FunctionalInterface
  public interface Maker {
    /** Makes the change of the values, in the units of files. */
    Change with(double... values);
  }

  /**
   * Makes the change of some values.
   *
   * @param values one for each parameter
   */
  public Change with(double... values) {
    if (values.length != parameters.size()) {
      throw new IllegalArgumentException(
          this + " takes " + parameters.size() + " values, not " + values.length);
    }
    return maker.with(values);
  }

  /** Returns the values at which the form is the nominal model. */
  public double[] neutral() {
    return parameters.stream().mapToDouble(Parameter::neutral).toArray();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Form that && effect == that.effect && name.equals(that.name);
  }

  @Override
  public int hashCode() {
    return 31 * effect.hashCode() + name.hashCode();
  }

  @Override
  public String toString() {
    return effect + "/" + name;
  }
}
