package simbad.cli;

import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Option;
import picocli.CommandLine.ScopeType;

/** {@code simbad} itself. */
@Command(
    name = "simbad",
    description = "A robot simulator whose sonar detects what a real SRF04 detects.",
    versionProvider = BuildVersion.class,
    subcommands = HelpCommand.class,
    commandListHeading = "%nCommands:%n",
    footer = {
      "",
      "Exit status: 0 done, 1 the work failed, 2 wrong usage or bad input.",
      "With SIMBAD_INSTALL=no in the environment nothing is installed with apt; "
          + "simbad says what to type instead. Other settings: docs/guide/first-run.md.",
      "",
      "Example: simbad COMMAND --help"
    })
final class RootCommand extends CommandGroup {
  @Option(
      names = {"-V", "--version"},
      versionHelp = true,
      description = "Print the version and the commit.")
  @SuppressWarnings("UnusedVariable") // picocli's
  private boolean versionRequested;

  // Read by Complaints, from any subcommand.
  @Option(
      names = Complaints.TRACE_OPTION,
      scope = ScopeType.INHERIT,
      preprocessor = TraceFileOption.class,
      description = "With an error, print its stack trace (also: SIMBAD_TRACE=1).")
  @SuppressWarnings("UnusedVariable") // picocli's
  private boolean trace;
}
