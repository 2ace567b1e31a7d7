package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.bag.BagExport;
import simbad.experiments.report.RunFiles;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.sonar.format.DataFormatException;

/** {@code simbad export bag}. */
@Command(
    name = "bag",
    description = {
      "Write the readings of a data set or of a run as a recording of ROS 2: a folder of rosbag2"
          + " in MCAP.",
      "Each sensor has a topic of sensor_msgs/msg/Range, and its places are in /tf.",
      "A run has readings if simbad run was called with --readings.",
      "Ranges become numbers of 32 bits, as in the message. Guide: docs/guide/bags.md."
    },
    footer = {
      "",
      "Example: simbad export bag data/gap/angle-against-uniform --out my-bag",
      "Example: simbad export bag my-run --out my-bag"
    })
final class ExportBagCommand extends Subcommand {
  @Parameters(
      paramLabel = "DATASET",
      description =
          "A folder with scene.json and readings.csv, or a run's folder that holds one such folder.")
  private Path set = Path.of("");

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "The recording's folder, which does not exist yet.")
  private Path out = Path.of("");

  @Override
  protected void run() throws Exception {
    DataSet data = new DataSetFolder(dataSet()).read();
    try (StagedDirectory staged = StagedDirectory.beside(out)) {
      BagExport.write(staged.path(), data.name(), data.setup(), data.readings());
      staged.publish();
    }
    out().println(data.readings().size() + " readings, written to " + out);
  }

  /** Of a run's folder the one that it holds. */
  private Path dataSet() throws IOException, DataFormatException {
    if (!Files.exists(set.resolve("errors.json"))) {
      return set;
    }
    List<Path> sets = RunFiles.dataSets(set);
    if (sets.isEmpty()) {
      throw DataFormatException.inFile(
          set, "is a run without readings, expected one of simbad run --readings");
    }
    if (sets.size() > 1) {
      throw DataFormatException.inFile(
          set,
          "is a run with several data sets, expected one of "
              + sets.stream().map(Path::toString).collect(Collectors.joining(", ")));
    }
    return sets.get(0);
  }
}
