package simbad.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;
import simbad.experiments.bag.BagTable;
import simbad.experiments.bag.Recording;
import simbad.experiments.dataset.LogImport;
import simbad.experiments.dataset.LogSettings;
import simbad.figures.report.LogPicture;
import simbad.gap.diagnosis.DataSet;
import simbad.sonar.format.DataFormatException;

/** {@code simbad dataset bag}: a recording of ROS 2 as a data set. */
@Command(
    name = "bag",
    sortOptions = false,
    abbreviateSynopsis = true,
    description = {
      "Make a data set from a recording of ROS 2: a folder of rosbag2, or a file in "
          + "MCAP or SQLite, plain or packed with lz4 or zstd.",
      "The ranges come from sensor_msgs/msg/Range, the sensors' places from /tf, "
          + "/tf_static and odometry.",
      "The options of simbad dataset csv add to this, or change it. Guide: docs/guide/bags.md."
    },
    footer = {
      "",
      "Example: simbad dataset bag data/logs/bags/post --list",
      "Example: simbad dataset bag data/logs/bags/post --target round:50mm --out my-data"
    })
final class DatasetBagCommand extends Subcommand {
  /** Options of this command alone. */
  private static final Set<String> OWN = Set.of("topic", "fixed-frame", "list", "picture");

  @Spec
  @SuppressWarnings("NullAway.Init")
  private CommandSpec self;

  @Parameters(paramLabel = "BAG", description = "The recording: a folder or a file.")
  private Path bag = Path.of("");

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "The data set's folder, which does not exist yet.")
  private @Nullable Path out;

  @Option(
      names = "--list",
      description = "Print the topics and the frames of the recording. Nothing is written.")
  private boolean list;

  @Option(
      names = "--topic",
      paramLabel = "TOPIC",
      split = ",",
      description = "Take only the ranges of these topics. Default: all topics.")
  private List<String> topics = List.of();

  @Option(
      names = "--fixed-frame",
      paramLabel = "FRAME",
      description = "Frame of the places. Default: the root above the sensors.")
  private @Nullable String fixedFrame;

  @Option(
      names = "--picture",
      paramLabel = "FILE",
      description =
          "Draw the data set, seen from above: where the sensors were, and where the "
              + "echoes came from. *.svg or *.png")
  private @Nullable Path picture;

  @Mixin
  @SuppressWarnings("UnusedVariable") // picocli's
  private CsvOptions options = new CsvOptions();

  @Override
  protected void run() throws Exception {
    if (list == (out != null)) {
      throw wrongUsage("expected either --out DIR or --list");
    }
    if (out == null) {
      sayContents();
      return;
    }
    if (picture != null) {
      requirePicture("--picture", picture);
      OutputFile.refuseExisting(picture);
    }
    Recording recording = Recording.read(bag);
    BagTable table =
        BagTable.of(recording, new LinkedHashSet<>(topics), Optional.ofNullable(fixedFrame));
    LogSettings said = CsvOptions.typed(self).without(OWN);
    LogImport.Made made =
        LogImport.ofText(
            bag, table.text(), said.orElse(table.settings()), TerminalQuestions.here(err()));
    said.refuseUnread();
    DatasetCommand.publish(made.data(), out, out());
    if (picture != null) {
      DataSet data =
          new DataSet(
              String.valueOf(out.getFileName()),
              made.data().setup(),
              made.data().readings(),
              List.of());
      OutputFile.draw(LogPicture.of(data, "recording: " + bag.getFileName()), picture);
    }
    made.notes().forEach(note -> err().println("note: " + note));
    table.notes().forEach(note -> out().println("read: " + note));
    made.data()
        .setup()
        .details()
        .assumptions()
        .forEach(assumption -> out().println("assumed: " + assumption));
    out().println(made.summary());
    out().println("again: " + again(said, out));
  }

  private void sayContents() throws DataFormatException {
    if (!CsvOptions.typed(self).without(Set.of("list")).words().isEmpty()) {
      throw wrongUsage("--list: expected no other option beside it");
    }
    Recording.read(bag).contents().forEach(out()::println);
  }

  /** What was typed: the rest stands in the recording. */
  private String again(LogSettings said, Path folder) {
    List<String> words = new ArrayList<>(List.of("./simbad", "dataset", "bag", bag.toString()));
    if (!topics.isEmpty()) {
      words.addAll(List.of("--topic", String.join(",", topics)));
    }
    if (fixedFrame != null) {
      words.addAll(List.of("--fixed-frame", fixedFrame));
    }
    words.addAll(said.words());
    words.addAll(List.of("--out", folder.toString()));
    return DatasetCsvCommand.line(words);
  }
}
