package simbad.experiments.program;

import java.util.List;

/**
 * How a program is run.
 *
 * @param classes the program
 * @param mainClass what is started
 * @param hasMain whether it has a main; if not, it is an environment that is shown
 * @param arguments of its main
 * @param compatibility the switches, as the system property has them
 * @param steps how many, of each world
 * @param seed of all chance
 * @param traced whether poses are kept
 */
public record RunPlan(
    ProgramClasses classes,
    String mainClass,
    boolean hasMain,
    List<String> arguments,
    String compatibility,
    long steps,
    long seed,
    boolean traced) {
  /**
   * What of a run does not depend on the program; as above.
   *
   * @param compatibility the switches
   * @param steps how many
   * @param seed of all chance
   * @param traced whether poses are kept
   */
  public record Settings(String compatibility, long steps, long seed, boolean traced) {}

  /** Copies the arguments. */
  public RunPlan {
    arguments = List.copyOf(arguments);
  }

  /** Returns the same run with other switches. */
  public RunPlan with(String newCompatibility) {
    return new RunPlan(
        classes, mainClass, hasMain, arguments, newCompatibility, steps, seed, traced);
  }
}
