package simbad.cli;

import java.io.PrintWriter;

/** Says that the command was interrupted when the process ends before the command does. */
final class Interruption {
  private final Ending announcement;

  private Interruption(Ending announcement) {
    this.announcement = announcement;
  }

  static Interruption announcedOn(PrintWriter err) {
    return new Interruption(Ending.with(() -> err.println("simbad: interrupted")));
  }

  void noLongerPossible() {
    announcement.close();
  }
}
