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
 * @param maker of the change with given values
 * @param remedy one sentence, with {@code %s} for the first value
 * @param clocks whether it stands for clocks that differ, and is looked for only where they may
 */
public record MotionForm(
    String effect,
    String form,
    List<MotionParameter> parameters,
    Function<double[], MotionChange> maker,
    String remedy,
    boolean clocks) {
  /** Copies the list. */
  public MotionForm {
    parameters = List.copyOf(parameters);
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

  /**
   * Tells whether two forms beside each other say something twice: a delay of commands and one of
   * the clock; a scale of both wheels and one of what they do together.
   */
  public boolean doublesWith(MotionForm other) {
    return doubles(this, other) || doubles(other, this);
  }

  /**
   * Tells whether it stands behind another lag, and is the same as that one where there is none.
   */
  public boolean followsALag() {
    return equals(Lag.SECOND) || equals(Lag.SECOND_BACK) || equals(Lag.SECOND_ACCELERATION);
  }

  /** Tells whether it is one factor for speed and turning. */
  public boolean scalesBoth() {
    return equals(Scale.WHEELS);
  }

  private static boolean doubles(MotionForm one, MotionForm other) {
    boolean delays = one.equals(Delay.CLOCKS) && other.equals(Delay.LATENCY);
    boolean scales =
        one.equals(Scale.WHEELS)
            && (other.effect().equals(Scale.SPEED.effect())
                || other.effect().equals(Scale.TURN.effect()));
    return delays || scales;
  }

  /** Returns the change that changes nothing. */
  public MotionChange neutral() {
    return change(neutralValues());
  }

  /** Returns the values at which nothing changes. */
  public double[] neutralValues() {
    return parameters.stream().mapToDouble(MotionParameter::neutral).toArray();
  }
}
