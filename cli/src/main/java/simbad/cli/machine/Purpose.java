package simbad.cli.machine;

import java.util.Locale;

/** What something has to be on a machine for. */
public enum Purpose {
  /** To run the program where it is built. */
  RUN("to run the program"),

  /** To build it. */
  BUILD("to build the program"),

  /** To open a window, with OpenGL. */
  WINDOW("for windows"),

  /** To run the simulated board. */
  BOARD("for the simulated board"),

  /** To run all tests. */
  TEST("for the tests");

  private final String why;

  Purpose(String why) {
    this.why = why;
  }

  /** Returns it as a sentence goes on: what is missing, "for windows". */
  public String why() {
    return why;
  }

  /** Returns the one of a name in the list of packages. */
  static Purpose of(String word) {
    return valueOf(word.toUpperCase(Locale.ROOT));
  }

  /** Returns its name in the list of packages. */
  String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
