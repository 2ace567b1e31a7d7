package simbad.cli;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import picocli.CommandLine;
import picocli.CommandLine.TypeConversionException;
import simbad.experiments.table.TableImport;
import simbad.sonar.format.Provenance;

/**
 * Reads numbers and words of the command line; what is none is told in a reader's words, not in
 * Java's.
 */
final class ArgumentText {
  private ArgumentText() {}

  /** Lets a command, with those that it has already, read its numbers and words. */
  static CommandLine readBy(CommandLine command) {
    Stream.of(double.class, Double.class)
        .forEach(type -> register(command, type, Double::valueOf, "a number"));
    Stream.of(int.class, Integer.class)
        .forEach(type -> register(command, type, Integer::valueOf, "a whole number"));
    Stream.of(long.class, Long.class)
        .forEach(type -> register(command, type, Long::valueOf, "a whole number"));
    word(command, Provenance.class);
    word(command, TableImport.Unit.class);
    return command;
  }

  private static <E extends Enum<E>> void word(CommandLine command, Class<E> type) {
    Map<String, E> words = new LinkedHashMap<>();
    for (E constant : type.getEnumConstants()) {
      words.put(constant.name().toLowerCase(Locale.ROOT), constant);
    }
    command.registerConverter(
        type,
        text ->
            Optional.ofNullable(words.get(text.toLowerCase(Locale.ROOT)))
                .orElseThrow(
                    () ->
                        new TypeConversionException(
                            "'" + text + "' is not one of " + String.join(", ", words.keySet()))));
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
