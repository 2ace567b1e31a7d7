package simbad.cli;

import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.bag.BagExport;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.DataSetFolder;

/** {@code simbad export bag}. */
@Command(
    name = "bag",
    description = {
      "Write a data set's readings as a recording of ROS 2: a folder of rosbag2 in " + "MCAP.",
      "Each sensor has a topic of sensor_msgs/msg/Range, and its places are in /tf.",
      "Ranges become numbers of 32 bits, as in the message. Guide: " + "docs/guide/bags.md."
    },
    footer = {"", "Example: simbad export bag data/gap/angle-against-uniform --out my-bag"})
final class ExportBagCommand extends Subcommand {
  @Parameters(paramLabel = "DATASET", description = "A folder with scene.json and readings.csv.")
  private Path set = Path.of("");

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "The recording's folder, which does not exist yet.")
  private Path out = Path.of("");

  @Override
  protected void run() throws Exception {
    DataSet data = new DataSetFolder(set).read();
    try (StagedDirectory staged = StagedDirectory.beside(out)) {
      BagExport.write(staged.path(), data.name(), data.setup(), data.readings());
      staged.publish();
    }
    out().println(data.readings().size() + " readings, written to " + out);
  }
}
