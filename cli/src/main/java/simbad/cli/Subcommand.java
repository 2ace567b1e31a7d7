package simbad.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * What every subcommand has: {@code -h}, the streams that it may print to, and a way to fail.
 *
 * <p>A subcommand only parses, calls a library and prints. It ends by returning (exit status 0) or
 * by throwing; {@link ExitStatus} says which exception means what. Not thread-safe.
 */
abstract class Subcommand implements Callable<Integer> {
  // Set by picocli before anything is run.
  @Spec
  @SuppressWarnings("NullAway.Init")
  private CommandSpec spec;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Say what this command does and how to call it.")
  @SuppressWarnings("UnusedVariable") // picocli's
  private boolean helpRequested;

  private int status = ExitStatus.DONE;

  /**
   * Does the work.
   *
   * @throws Exception when it cannot be done
   */
  protected abstract void run() throws Exception;

  @Override
  public final Integer call() throws Exception {
    status = ExitStatus.DONE;
    run();
    return status;
  }

  /** Where results go. */
  protected final PrintWriter out() {
    return spec.commandLine().getOut();
  }

  /** Where complaints and progress go. */
  protected final PrintWriter err() {
    return spec.commandLine().getErr();
  }

  /**
   * Says what went wrong and lets the command go on, for commands that take several inputs; the
   * worst complaint gives the exit status.
   *
   * @param fault what one of the inputs ended with
   */
  protected final void complain(Exception fault) {
    status = Math.max(status, Complaints.of(spec.commandLine()).about(fault));
  }

  /**
   * Has the exit status be that of another process, which did the work.
   *
   * @param other its exit status
   */
  protected final void endAs(int other) {
    status = other;
  }

  /** Returns the command line that this runs for, as it was typed. */
  protected final List<String> words() {
    return spec.root().commandLine().getParseResult().originalArgs();
  }

  /**
   * Wrong usage that picocli cannot see by itself, such as two options that exclude each other.
   *
   * @param problem what is wrong and what was expected
   */
  protected final CommandLine.ParameterException wrongUsage(String problem) {
    return new CommandLine.ParameterException(spec.commandLine(), problem);
  }

  /**
   * Wrong usage that a check of the library found. It names its value; the option is called the
   * same, but for the unit.
   *
   * @param fault of one value
   */
  protected final CommandLine.ParameterException wrongUsage(IllegalArgumentException fault) {
    String problem = String.valueOf(fault.getMessage());
    String[] parts = problem.split(" = ", 2);
    String option = "--" + parts[0].replaceFirst("(M|S|C|Deg|Percent)$", "");
    boolean known = parts.length == 2 && spec.optionsMap().containsKey(option);
    return wrongUsage(known ? option + ": " + parts[1] : problem);
  }

  /** Prints the help of this command. */
  protected final void usage(PrintWriter to) {
    spec.commandLine().usage(to);
    to.println();
  }

  /**
   * Refuses a file for a picture whose ending names no format.
   *
   * @param option that gave it
   * @param file to be drawn
   */
  protected final void requirePicture(String option, Path file) {
    if (!OutputFile.isPicture(file)) {
      throw wrongUsage(option + ": '" + file + "' ends neither in .png nor in .svg");
    }
  }
}
