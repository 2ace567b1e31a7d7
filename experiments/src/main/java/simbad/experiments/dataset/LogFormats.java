package simbad.experiments.dataset;

import java.nio.charset.Charset;
import java.util.Optional;
import simbad.sonar.format.DataFormatException;

/** How a log is written, as the options say it. */
final class LogFormats {
  private static final int MOST_SKIPPED = 1_000_000;

  private LogFormats() {}

  static LogFormat of(LogSettings settings) throws DataFormatException {
    return new LogFormat(
        encoding(settings),
        separator(settings),
        choice(settings, "decimal", "comma", "point"),
        choice(settings, "header", "yes", "no"),
        settings.findNumber("skip", 0, MOST_SKIPPED).map(Double::intValue).orElse(0),
        settings.find("comment").filter(start -> !start.isEmpty()),
        settings.has(LogSettings.SKIP_BAD));
  }

  private static Optional<Boolean> choice(
      LogSettings settings, String option, String yes, String no) throws DataFormatException {
    return settings.has(option)
        ? Optional.of(settings.word(option, yes, no).equals(yes))
        : Optional.empty();
  }

  private static Optional<Charset> encoding(LogSettings settings) throws DataFormatException {
    Optional<String> name = settings.find("encoding");
    try {
      return name.map(Charset::forName);
    } catch (IllegalArgumentException e) {
      throw LogSettings.fault(
          "encoding",
          "'" + name.orElse("") + "' is not an encoding, expected for example UTF-8, latin1");
    }
  }

  private static Optional<Character> separator(LogSettings settings) throws DataFormatException {
    Optional<String> word = settings.find("separator");
    if (word.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        switch (word.get()) {
          case "comma", "," -> ',';
          case "semicolon", ";" -> ';';
          case "tab", "\t", "\\t" -> '\t';
          case "bar", "|" -> '|';
          case "blank", "blanks", " " -> ' ';
          case ":" -> ':';
          default ->
              throw LogSettings.fault(
                  "separator",
                  "'" + word.get() + "' is not one of comma, semicolon, tab, bar, blanks");
        });
  }
}
