package simbad.cli;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.stream.Stream;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import simbad.experiments.run.DiagnosedFolder;

/**
 * Which argument a complaint is about. What is wrong inside a file begins with the file and the
 * line, as editors expect it; what is said of a path that is no file begins with the option that
 * names it.
 */
final class ArgumentOf {
  private static final String END = ": ";

  private ArgumentOf() {}

  /**
   * Returns the name of the argument, with a colon and a blank; empty where none is meant.
   *
   * @param command whose arguments were parsed
   * @param line of the complaint
   * @param isInTheWay whether a file is complained of because it is there
   */
  static String line(CommandSpec command, String line, boolean isInTheWay) {
    return command.args().stream()
        .filter(argument -> argument.stringValues().stream().anyMatch(v -> begins(line, v)))
        .filter(argument -> isInTheWay || !isFile(line.split(END, 2)[0]))
        .findFirst()
        .map(argument -> name(argument) + END)
        .orElse("");
  }

  /** Whether a line is about a value as it was typed, or about something in that folder. */
  private static boolean begins(String line, String typed) {
    String value = DiagnosedFolder.in(typed).orElse(typed);
    return !value.isEmpty()
        && Stream.of(value + END, value + "/", "'" + value + "'" + END).anyMatch(line::startsWith);
  }

  private static boolean isFile(String text) {
    try {
      // A line number, if there is one, comes after the first colon.
      return Files.isRegularFile(Path.of(text.split(":[0-9]", 2)[0]));
    } catch (InvalidPathException e) {
      return false;
    }
  }

  private static String name(ArgSpec argument) {
    return argument instanceof OptionSpec option ? option.longestName() : argument.paramLabel();
  }
}
