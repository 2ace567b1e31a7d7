package simbad.cli;

import java.io.IOException;
import picocli.CommandLine.Command;
import simbad.cli.machine.Doctor;
import simbad.cli.machine.Machine;
import simbad.cli.machine.SaidAlreadyException;

/**
 * {@code simbad doctor}. The launcher runs the same where nothing is built ({@link
 * simbad.cli.machine.OnTheSpot}).
 */
@Command(
    name = "doctor",
    description = {
      "Say what works on this machine, and what to install for the rest: Java, build, windows and"
          + " OpenGL, the simulated board, serial ports, tests.",
      "Exit status 1 if the program itself cannot be built and run."
    },
    footer = {"", "Example: simbad doctor"})
final class DoctorCommand extends Subcommand {
  @Override
  protected void run() throws IOException, InterruptedException {
    if (!Doctor.examine(Machine.here(ProjectFolder.find()), out()::println)) {
      throw new SaidAlreadyException();
    }
  }
}
