package simbad.cli;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import simbad.experiments.dataset.LogImport;
import simbad.sonar.format.DataFormatException;

/** {@code simbad dataset csv}: a person's log as a data set. */
@Command(
    name = "csv",
    sortOptions = false,
    abbreviateSynopsis = true,
    description = {
      "Make a data set from a log of your own: a table of ranges, with the places of "
          + "sensor and target as far as you know them.",
      "If you leave something out, the command guesses it from the columns' names, asks "
          + "for it at a terminal, or assumes it. It writes every assumption into scene.json.",
      "Guide: docs/guide/own-log.md."
    },
    footer = {
      "",
      "Example: simbad dataset csv my-log.csv --range reading_cm --distance true_cm --out my-data",
      "Example: simbad dataset csv my-scan.csv --range us --range-unit us --no-echo 0 --x x_mm --y"
          + " y_mm --heading up_deg --angle-zero up --angle-positive cw --target round:30mm --out"
          + " my-data"
    })
final class DatasetCsvCommand extends DatasetCommand.Maker {
  private static final String PLAIN_WORD = "[\\w./:,=+@-]+";

  @Spec
  @SuppressWarnings("NullAway.Init")
  private CommandSpec self;

  @Parameters(
      paramLabel = "LOG.csv",
      arity = "1..*",
      description =
          "The log, plain or gzipped. Several files with the same columns are read as "
              + "one log.")
  private List<String> logs = List.of();

  @Mixin
  @SuppressWarnings("UnusedVariable") // picocli's
  private CsvOptions options = new CsvOptions();

  @Override
  protected void run() throws Exception {
    LogImport.Made made =
        LogImport.of(files(), CsvOptions.typed(self), TerminalQuestions.here(err()));
    publish(made.data());
    made.notes().forEach(note -> err().println("note: " + note));
    made.data()
        .setup()
        .details()
        .assumptions()
        .forEach(assumption -> out().println("assumed: " + assumption));
    out().println(made.summary());
    out().println("again: " + again(made));
  }

  private List<Path> files() throws DataFormatException {
    List<Path> files = new ArrayList<>();
    for (String log : logs) {
      try {
        files.add(Path.of(log));
      } catch (InvalidPathException e) {
        throw DataFormatException.inArgument("LOG.csv '" + log + "'", "is not the name of a file");
      }
    }
    return files;
  }

  private String again(LogImport.Made made) {
    List<String> words = new ArrayList<>(List.of("./simbad", "dataset", "csv"));
    words.addAll(logs);
    words.addAll(made.settings().words());
    words.add("--out");
    words.add(folder().toString());
    return line(words);
  }

  /** Returns words as one types them in a shell. */
  static String line(List<String> words) {
    return words.stream().map(DatasetCsvCommand::quoted).collect(Collectors.joining(" "));
  }

  /** As a shell takes it for one word. */
  private static String quoted(String word) {
    return word.matches(PLAIN_WORD) ? word : "'" + word.replace("'", "'\\''") + "'";
  }
}
