package simbad.chance;

import java.util.function.Predicate;

/** Makes a program that shows something as small as it can be while it still shows it. */
final class Shrinking {
  private Shrinking() {}

  /**
   * Leaves out one thing after the other, then steps.
   *
   * @param shows true of the program that is given, and of the one that comes back
   */
  static RandomProgram smallest(RandomProgram program, Predicate<RandomProgram> shows) {
    RandomProgram small = program;
    boolean shrunk = true;
    while (shrunk) {
      shrunk = false;
      for (int i = small.things().size() - 1; i >= 0; i--) {
        RandomProgram fewer = small.without(i);
        if (shows.test(fewer)) {
          small = fewer;
          shrunk = true;
        }
      }
    }
    for (int steps = small.steps() / 2; steps > 0; steps /= 2) {
      while (small.steps() > steps && shows.test(small.lasting(small.steps() - steps))) {
        small = small.lasting(small.steps() - steps);
      }
    }
    return small;
  }
}
