package simbad.sonar.effect;

import java.util.List;
import java.util.Optional;

/**
 * One functional form of an effect, or one calibration of the set-up: its parameters in the units
 * of files, and the change that they make.
 *
 * @param of the effect that it is a form of; empty for a calibration of the set-up
 * @param name of the form among the forms of its effect, or among the calibrations
 * @param parameters in the order of the values that {@link #with} takes
 * @param maker of the change
 */
public record Form(Optional<Effect> of, String name, List<Parameter> parameters, Maker maker) {
  private static final int LARGEST_SEARCHED = 12;

  /** Copies the parameters. */
  public Form {
    parameters = List.copyOf(parameters);
  }

  /** Creates a form of an effect. */
  public Form(Effect effect, String name, List<Parameter> parameters, Maker maker) {
    this(Optional.of(effect), name, parameters, maker);
  }

  /**
   * Creates a form of an effect.
   *
   * @param effect that it is a form of
   * @param name of the form among the forms of its effect, as in files
   * @param maker of the change
   * @param parameters in the order of the values that the maker takes
   */
  public static Form of(Effect effect, String name, Maker maker, Parameter... parameters) {
    return new Form(effect, name, List.of(parameters), maker);
  }

  /**
   * Tells whether it is a table: so many values that they are read off a log one by one, since
   * moving all of them at once leads nowhere.
   */
  public boolean isTable() {
    return parameters.size() > LARGEST_SEARCHED;
  }

  /**
   * Returns the effect that it is a form of.
   *
   * @throws IllegalStateException for a calibration of the set-up, which is a form of none
   */
  public Effect effect() {
    return of.orElseThrow(() -> new IllegalStateException(name + " calibrates the set-up"));
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
    return other instanceof Form that && of.equals(that.of) && name.equals(that.name);
  }

  @Override
  public int hashCode() {
    return 31 * of.hashCode() + name.hashCode();
  }

  @Override
  public String toString() {
    return of.map(Effect::word).orElse("setup") + "/" + name;
  }
}
