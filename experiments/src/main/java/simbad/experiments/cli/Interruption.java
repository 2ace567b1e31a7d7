package simbad.experiments.cli;

import java.io.PrintWriter;

/** Says that the command was interrupted when the process ends before the command does. */
final class Interruption {
  private final Thread announcement;

  private Interruption(Thread announcement) {
    this.announcement = announcement;
  }

  static Interruption announcedOn(PrintWriter err) {
    Thread announcement = new Thread(() -> err.println("simbad: interrupted"));
    Runtime.getRuntime().addShutdownHook(announcement);
    return new Interruption(announcement);
  }

  void noLongerPossible() {
    Runtime.getRuntime().removeShutdownHook(announcement);
  }
}
