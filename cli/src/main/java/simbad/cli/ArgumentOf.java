package simbad.cli;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
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

  /** What is said of a file as such, which is no fault inside it. */
  private static final Pattern AS_SUCH = Pattern.compile(": is (not a (folder|jar)|neither )");

  private static final Pattern NO_COLUMN = Pattern.compile(":\\d+: (.+?): column is missing; ");

  private ArgumentOf() {}

  /**
   * Returns who asked for a column that a table does not have, in brackets after a blank; empty for
   * another complaint, and where no option named the column.
   *
   * @param command whose arguments were parsed
   * @param line of the complaint
   */
  static String column(CommandSpec command, String line) {
    Matcher missing = NO_COLUMN.matcher(line);
    if (!missing.find()) {
      return "";
    }
    return command.options().stream()
        .filter(
            option ->
                option.originalStringValues().stream()
                    .anyMatch(typed -> List.of(typed.split(",")).contains(missing.group(1))))
        .findFirst()
        .map(option -> " (" + name(option) + ")")
        .orElse("");
  }

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
        .filter(
            argument ->
                isInTheWay || AS_SUCH.matcher(line).find() || !isFile(line.split(END, 2)[0]))
        .findFirst()
        .map(argument -> name(argument) + END)
        .orElse("");
  }

  /** Whether a line is about a value as it was typed, or about something in that folder. */
  private static boolean begins(String line, String typed) {
    String value = DiagnosedFolder.in(typed).orElse(typed);
    return !value.isEmpty()
        && Stream.of(value + END, value + "/", "'" + value + "'" + END, absolute(value) + END)
            .anyMatch(line::startsWith);
  }

  /** A path is told in full where it is kept for later, as a port is. */
  private static String absolute(String value) {
    try {
      return Path.of(value).toAbsolutePath().toString();
    } catch (InvalidPathException e) {
      return value;
    }
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
