package simbad.experiments.control;

/**
 * A number that tunes a kind of controller.
 *
 * @param name with its unit, as in files: {@code crossing_angle_deg}
 * @param standard the value where none is given, in [low, high]
 * @param low least value that makes sense
 * @param high greatest value that makes sense
 */
public record ControllerParameter(String name, double standard, double low, double high) {
  /** Checks that the standard value is permitted. */
  public ControllerParameter {
    if (!(standard >= low && standard <= high)) {
      throw new IllegalArgumentException(
          name + " = " + standard + " is not in [" + low + ", " + high + "]");
    }
  }

  /** Tells whether it may have a value. */
  public boolean permits(double value) {
    return value >= low && value <= high;
  }
}
