package simbad.motion.effect;

import java.util.List;
import java.util.function.Function;
import simbad.motion.MotionChange;

/**
 * One form of a motion effect.
 *
 * @param effect its name in the vocabulary
 * @param form its own name, unique among all forms
 * @param parameters in the order of their values
 * @param starts values that a fit begins at
 * @param maker of the change with given values
 * @param remedy one sentence, with {@code %s} for the first value
 * @param clocks whether it stands for clocks that differ, and is looked for only where they may
 */
public record MotionForm(
    String effect,
    String form,
    List<MotionParameter> parameters,
    List<double[]> starts,
    Function<double[], MotionChange> maker,
    String remedy,
    boolean clocks) {
  /** Copies the lists and checks that every start has a value per parameter. */
  public MotionForm {
    parameters = List.copyOf(parameters);
    starts = starts.stream().map(double[]::clone).toList();
    for (double[] start : starts) {
      if (start.length != parameters.size()) {
        throw new IllegalArgumentException(form + ": a start has " + start.length + " values");
      }
    }
  }

  /**
   * Makes the change.
   *
   * @param values one per parameter, within its bounds or neutral
   */
  public MotionChange change(double... values) {
    if (values.length != parameters.size()) {
      throw new IllegalArgumentException(form + ": " + values.length + " values");
    }
    for (int i = 0; i < values.length; i++) {
      MotionParameter parameter = parameters.get(i);
      boolean allowed = values[i] >= parameter.low() && values[i] <= parameter.high();
      if (!allowed && values[i] != parameter.neutral()) {
        throw new IllegalArgumentException(
            parameter.name()
                + " = "
                + values[i]
                + " is not in ["
                + parameter.low()
                + ", "
                + parameter.high()
                + "]");
      }
    }
    return maker.apply(values.clone());
  }

  /** Returns the change that changes nothing. */
  public MotionChange neutral() {
    return change(parameters.stream().mapToDouble(MotionParameter::neutral).toArray());
  }
}
