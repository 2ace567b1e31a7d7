package simbad.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NoSuchFileException;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.regex.Pattern;
import picocli.CommandLine;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.UnmatchedArgumentException;
import simbad.cli.machine.SaidAlreadyException;
import simbad.sonar.format.OneLine;

/** Says in one line on standard error what went wrong. */
final class Complaints {
  /** What a file is called may be long, and stands at the begin; what is wrong at the end. */
  private static final int LONGEST = 1000;

  private static final int LONGEST_USAGE = 320;
  private static final int LONGEST_ARGUMENT = 80;

  static final String TRACE_OPTION = "--trace";

  /** A folder that is not published yet goes by the name that it was to have. */
  private static final Pattern STAGED = Pattern.compile("\\.([^/]+)\\.unfinished-[^/:]+(?=/|:|$)");

  private final CommandLine command;
  private final String commandName;
  private final PrintWriter err;
  private final boolean trace;

  private Complaints(CommandLine command, boolean trace) {
    this.command = command;
    this.commandName = command.getCommandSpec().qualifiedName();
    this.err = command.getErr();
    this.trace = trace;
  }

  /** Complaints of a command that runs or cannot run. */
  static Complaints of(CommandLine command) {
    return new Complaints(command, wantsTrace(command));
  }

  /** Prints the line, and the stack trace where it is asked for; returns the exit status. */
  int about(Throwable fault) {
    // Of what the end took away.
    Ending.goOnUnlessItEnds();
    if (ExitStatus.unwrapped(fault) instanceof SaidAlreadyException) {
      return ExitStatus.rules().of(fault);
    }
    String line = STAGED.matcher(line(fault)).replaceAll("$1");
    boolean isInTheWay = ExitStatus.unwrapped(fault) instanceof FileAlreadyExistsException;
    String argument = ArgumentOf.line(command.getCommandSpec(), line, isInTheWay);
    String column = ArgumentOf.column(command.getCommandSpec(), line);
    err.println(commandName + ": " + OneLine.of(argument + line + column, LONGEST));
    if (trace) {
      fault.printStackTrace(err);
    }
    err.flush();
    return ExitStatus.rules().of(fault);
  }

  private static boolean wantsTrace(CommandLine command) {
    CommandLine root = command;
    while (root.getParent() != null) {
      root = root.getParent();
    }
    // The raw arguments, because a line that does not parse can be traced as well.
    CommandLine.ParseResult parsed = root.getParseResult();
    List<String> words = parsed == null ? List.of() : parsed.originalArgs();
    // Of this command it is another option, with a file.
    boolean takesFile = !words.isEmpty() && words.get(0).equals("program");
    boolean asked = !takesFile && words.contains(TRACE_OPTION);
    return asked || isSet(System.getenv(), "SIMBAD_TRACE");
  }

  private static boolean isSet(Map<String, String> environment, String name) {
    return !List.of("", "0").contains(environment.getOrDefault(name, ""));
  }

  private String line(Throwable thrown) {
    Throwable fault = ExitStatus.unwrapped(thrown);
    if (fault instanceof UnmatchedArgumentException unmatched) {
      return unmatched(unmatched) + seeHelp();
    }
    if (fault instanceof ParameterException) {
      return OneLine.of(textOf(fault), LONGEST_USAGE) + seeHelp();
    }
    if (fault instanceof IOException io) {
      return inputOutput(io);
    }
    if (fault instanceof ServiceConfigurationError) {
      return "a jar of the class path: " + textOf(fault);
    }
    boolean isForeseen = ExitStatus.rules().of(fault) == ExitStatus.BAD_INPUT;
    if (!isForeseen && (fault instanceof RuntimeException || fault instanceof Error)) {
      return "a fault in the program: " + fault + (trace ? "" : " (SIMBAD_TRACE=1 shows where)");
    }
    return textOf(fault);
  }

  private static String unmatched(UnmatchedArgumentException fault) {
    String argument = fault.getUnmatched().get(0);
    String kind = argument.startsWith("-") ? "option" : "command or argument";
    List<String> suggestions = fault.getSuggestions(); // The most similar first.
    String instead = suggestions.isEmpty() ? "" : "; did you mean " + suggestions.get(0) + "?";
    return "unknown " + kind + " '" + OneLine.of(argument, LONGEST_ARGUMENT) + "'" + instead;
  }

  private String seeHelp() {
    return " (see " + commandName + " --help)";
  }

  /** The JDK's messages for these are a path and nothing else. */
  private static String inputOutput(IOException fault) {
    if (fault instanceof NoSuchFileException missing) {
      return missing.getFile() + ": there is no such file";
    }
    if (fault instanceof AccessDeniedException denied) {
      return denied.getFile() + ": permission denied";
    }
    if (fault instanceof FileAlreadyExistsException existing) {
      return existing.getFile() + ": exists already";
    }
    return textOf(fault);
  }

  private static String textOf(Throwable fault) {
    String message = fault.getMessage();
    return message == null ? fault.getClass().getSimpleName() : message;
  }
}
