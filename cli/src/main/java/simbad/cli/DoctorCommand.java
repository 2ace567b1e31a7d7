package simbad.cli;

import picocli.CommandLine.Command;

/**
 * Stands in the help for what the launcher does itself, because it must work where there is no
 * Java.
 */
@Command(
    name = "doctor",
    description = {
      "Say what works on this machine, and what to install for the rest: Java, build, windows and"
          + " OpenGL, the simulated board, serial ports, tests.",
      "Exit status 1 when not even the program itself can be built and run."
    },
    footer = {"", "Example: simbad doctor"})
final class DoctorCommand extends Subcommand {
  @Override
  protected void run() {
    throw wrongUsage("only the launcher can look at the machine: call ./simbad doctor");
  }
}
