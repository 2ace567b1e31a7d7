package simbad.cli;

import java.nio.file.Path;
import java.util.Map;
import java.util.Stack;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.IParameterPreprocessor;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
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
      preprocessor = TraceFile.class,
      description = "With an error, print its stack trace (also: SIMBAD_TRACE=1).")
  @SuppressWarnings("UnusedVariable") // picocli's
  private boolean trace;

  /** Of {@code simbad program}, {@code --trace} takes a file; of all other commands, nothing. */
  static final class TraceFile implements IParameterPreprocessor {
    @Override
    @SuppressWarnings({"JdkObsolete", "NonApiType"}) // The signature is picocli's.
    public boolean preprocess(
        Stack<String> args, CommandSpec command, ArgSpec option, Map<String, Object> info) {
      boolean takes = command.userObject() instanceof ProgramCommand && !args.isEmpty();
      if (takes && !args.peek().startsWith("-")) {
        ((ProgramCommand) command.userObject()).setTrace(Path.of(args.pop()));
      }
      return false;
    }
  }
}
