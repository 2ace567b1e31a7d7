package simbad.experiments.control;

import java.util.List;
import java.util.Map;

/**
 * Makes controllers of one kind, by the name and the parameters that a file gives.
 *
 * <p>A jar adds its own: a class with a public constructor without arguments that it names in
 * {@code META-INF/services/simbad.experiments.control.ControllerMaker}.
 */
public interface ControllerMaker {
  /** Returns the name of the kind, short, as in files; no other kind has it. */
  String name();

  /** Returns the parameters, names distinct. */
  List<ControllerParameter> parameters();

  /**
   * Makes a controller that has read nothing yet. Every robot gets one of its own.
   *
   * @param speedMPerS that the robot shall drive at, positive
   * @param stepS the simulator's time step, positive
   * @param values one for each parameter, by name, each permitted
   * @throws IllegalArgumentException if the values do not go together
   */
  Controller make(double speedMPerS, double stepS, Map<String, Double> values);
}
