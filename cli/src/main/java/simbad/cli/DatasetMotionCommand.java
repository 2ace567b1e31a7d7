package simbad.cli;

import java.io.IOException;
import java.nio.file.Path;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.motion.MrclamLog;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionFolder;
import simbad.sonar.format.DataFormatException;

/** {@code simbad dataset motion}: motion folders out of others' logs. */
@Command(
    name = "motion",
    description =
        "Make a motion folder for simbad diagnose from a log of what a robot was told"
            + " and what it did.",
    subcommands = {
      DatasetMotionCsvCommand.class,
      DatasetMotionBagCommand.class,
      DatasetMotionCommand.Mrclam.class
    },
    footer = {
      "",
      "Example: simbad dataset motion csv my-commands.csv my-track.csv --out my-robot",
      "Example: simbad dataset motion bag my-drive --out my-robot",
      "Example: simbad dataset motion mrclam my-odometry.txt my-track.txt --out my-robot"
    })
final class DatasetMotionCommand extends CommandGroup {
  /** Publishes a motion folder whole. */
  static void publish(MotionData data, Path folder) throws IOException, DataFormatException {
    try (StagedDirectory staged = StagedDirectory.beside(folder)) {
      MotionFolder written = new MotionFolder(staged.path());
      written.write(data);
      // What is written can be diagnosed, or is not left behind.
      written.read(data.name());
      staged.publish();
    }
  }

  /** {@code simbad dataset motion mrclam}. */
  @Command(
      name = "mrclam",
      description = {
        "Read a log in the form of the UTIAS data set of cooperative localization.",
        "One file has time, speed and turn rate; the other has time, x, y (up the page) "
            + "and heading in radians. Files may be gzipped."
      },
      footer = {
        "",
        "Example: simbad dataset motion mrclam my-odometry.txt my-track.txt --out my-robot"
      })
  static final class Mrclam extends Subcommand {
    @Parameters(index = "0", paramLabel = "ODOMETRY", description = "The commands.")
    private Path odometry = Path.of("");

    @Parameters(index = "1", paramLabel = "TRACK", description = "Where the robot was.")
    private Path track = Path.of("");

    @Option(
        names = "--out",
        paramLabel = "DIR",
        required = true,
        description = "The motion folder, which does not exist yet.")
    private Path out = Path.of("");

    @Override
    protected void run() throws Exception {
      publish(MrclamLog.read(odometry, track, "log"), out);
      out().println("written to " + out);
    }
  }
}
