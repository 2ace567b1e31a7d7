package simbad.experiments.program;

/** Ends a program from within, past its own handlers of exceptions. */
final class ProgramEnd extends Error {
  private static final long serialVersionUID = 1;

  ProgramEnd() {
    super("the run ends", null, false, false);
  }
}
