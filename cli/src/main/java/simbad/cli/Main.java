package simbad.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine;
import simbad.sonar.format.TemporaryFolder;

/** The program: parses the command line, runs one command, ends with its exit status. */
public final class Main {
  /** Of Java's own pool of threads: how many there are. */
  private static final String THREADS = "java.util.concurrent.ForkJoinPool.common.parallelism";

  private Main() {}

  /**
   * Runs one command and exits.
   *
   * @param arguments the command line
   */
  public static void main(String... arguments) {
    PrintWriter err = utf8(FileDescriptor.err);
    Ending interrupted = Ending.with(() -> err.println("simbad: interrupted"));
    int status = runInThisProcess(err, arguments);
    interrupted.close();
    System.exit(status);
  }

  /** Runs one command as the work of this process, which ends with the status afterwards. */
  static int runInThisProcess(PrintWriter err, String... arguments) {
    // Numbers and results look the same wherever the user lives.
    Locale.setDefault(Locale.ROOT);
    WindowsAllowed.noneUnlessAsked();
    // One more than Java takes: a thread that waits for another's work cannot help with all of it.
    if (System.getProperty(THREADS) == null) {
      System.setProperty(THREADS, String.valueOf(Runtime.getRuntime().availableProcessors()));
    }
    Ending tidying = Ending.with(TemporaryFolder::closeAll);
    PrintWriter out = utf8(FileDescriptor.out);
    int status = OwnClasses.areThere(err) ? run(out, err, arguments) : ExitStatus.BAD_INPUT;
    tidying.close();
    return status;
  }

  /**
   * Runs one command in a program of somebody else's, which goes on afterwards.
   *
   * @param out for results
   * @param err for complaints
   * @param arguments the command line
   * @return the exit status: 0 done, 1 the work failed, 2 bad input
   */
  public static int run(PrintWriter out, PrintWriter err, String... arguments) {
    return run(Subcommands.all(), out, err, arguments);
  }

  /** Not {@code System.out}, which swallows errors such as a full disk. */
  static PrintWriter utf8(FileDescriptor stream) {
    return new PrintWriter(
        new PipeOutput(new FileOutputStream(stream)), true, StandardCharsets.UTF_8);
  }

  /**
   * Runs one command.
   *
   * @param subcommands what there is
   * @param out for results
   * @param err for complaints
   * @param arguments the command line
   * @return the exit status
   */
  static int run(
      List<? extends Subcommand> subcommands,
      PrintWriter out,
      PrintWriter err,
      String... arguments) {
    CommandLine simbad = commandLine(named(subcommands, arguments)).setOut(out).setErr(err);
    int status;
    try {
      status = simbad.execute(arguments);
    } catch (Throwable unforeseen) { // Errors: picocli passes on exceptions only.
      status = Complaints.of(simbad).about(unforeseen);
    }
    if (out.checkError() && status == ExitStatus.DONE) {
      return Complaints.of(simbad).about(new IOException("cannot write to standard output"));
    }
    return status;
  }

  /**
   * The subcommand that a command line begins with, all where it begins otherwise: to read what all
   * of them take costs a quarter of the time of a short command. Completion tells of all.
   */
  private static List<? extends Subcommand> named(
      List<? extends Subcommand> subcommands, String... arguments) {
    return subcommands.stream()
        .filter(subcommand -> arguments.length > 0 && !(subcommand instanceof CompletionCommand))
        .filter(subcommand -> arguments[0].equals(name(subcommand)))
        .findFirst()
        .<List<? extends Subcommand>>map(List::of)
        .orElse(subcommands);
  }

  /**
   * Asked for help, picocli passes over words that it does not know: whoever mistyped a command
   * would read the help of something else.
   */
  private static int execute(CommandLine.ParseResult parsed) {
    CommandLine.ParseResult last = parsed;
    while (last.hasSubcommand()) {
      last = last.subcommand();
    }
    CommandLine command = last.commandSpec().commandLine();
    List<String> unknown = last.unmatched();
    if (command.getCommand() instanceof CommandGroup
        && !unknown.isEmpty()
        && !unknown.get(0).startsWith("-")) {
      throw new CommandLine.UnmatchedArgumentException(command, unknown);
    }
    return new CommandLine.RunLast().execute(parsed);
  }

  private static String name(Subcommand subcommand) {
    return subcommand.getClass().getAnnotation(CommandLine.Command.class).name();
  }

  /** The parser of all of it; its help and its complaints are where they are by themselves. */
  static CommandLine commandLine(List<? extends Subcommand> subcommands) {
    CommandLine simbad = new CommandLine(new RootCommand());
    subcommands.forEach(simbad::addSubcommand);
    return ArgumentText.readBy(simbad)
        .setAbbreviatedOptionsAllowed(false)
        .setCaseInsensitiveEnumValuesAllowed(true)
        .setExecutionStrategy(Main::execute)
        .setParameterExceptionHandler(
            (fault, arguments) -> Complaints.of(fault.getCommandLine()).about(fault))
        .setExecutionExceptionHandler(
            (fault, command, parsed) -> Complaints.of(command).about(fault));
  }
}
