package simbad.cli;

import java.util.function.Function;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.TypeConversionException;

/** Reads numbers of the command line; what is none is told in a reader's words, not in Java's. */
final class NumberArgument {
  private NumberArgument() {}

  /** Lets a command, with those that it has already, read its numbers. */
  static CommandLine readBy(CommandLine command) {
    Stream.of(double.class, Double.class)
        .forEach(type -> register(command, type, Double::valueOf, "a number"));
    Stream.of(int.class, Integer.class)
        .forEach(type -> register(command, type, Integer::valueOf, "a whole number"));
    Stream.of(long.class, Long.class)
        .forEach(type -> register(command, type, Long::valueOf, "a whole number"));
    return command;
  }

  @SuppressWarnings("unchecked") // int.class is a Class<Integer>
  private static <T> void register(
      CommandLine command, Class<?> type, Function<String, T> read, String what) {
    command.registerConverter(
        (Class<T>) type,
        text -> {
          try {
            return read.apply(text);
          } catch (NumberFormatException e) {
            boolean isWhole = text.matches("[+-]?\\d+");
            throw new TypeConversionException(
                "'" + text + "' is " + (isWhole ? "too large" : "not " + what));
          }
        });
  }
}
