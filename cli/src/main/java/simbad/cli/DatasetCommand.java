package simbad.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.dataset.LadderLog;
import simbad.experiments.dataset.MadeDataSet;
import simbad.experiments.dataset.PlotterLog;
import simbad.experiments.dataset.TableGrid;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SensorFile;
import simbad.sonar.scene.SonarSpec;

/** {@code simbad dataset}: data sets for the diagnosis, made of other things. */
@Command(
    name = "dataset",
    description = "Make data sets for simbad diagnose from a log, or from a threshold table.",
    subcommands = {
      DatasetCsvCommand.class,
      DatasetBagCommand.class,
      DatasetCommand.Grid.class,
      DatasetCommand.Ladder.class,
      DatasetCommand.Plotter.class,
      DatasetMendCommand.class,
      DatasetMotionCommand.class
    },
    footer = {
      "",
      "Example: simbad dataset csv my-log.csv --range reading_cm --distance true_cm --out my-data",
      "Example: simbad dataset grid angle --out angle-against-uniform"
    })
final class DatasetCommand extends CommandGroup {

  /** A command that makes one data set. */
  abstract static class Maker extends Subcommand {
    @Option(
        names = "--out",
        paramLabel = "DIR",
        required = true,
        description = "The data set's folder, which does not exist yet.")
    private Path out = Path.of("");

    /** Where it goes. */
    final Path folder() {
      return out;
    }

    /** Publishes the data set whole. */
    final void publish(MadeDataSet made) throws IOException, DataFormatException {
      DatasetCommand.publish(made, out, out());
    }
  }

  /** Publishes a data set whole, and says so. */
  static void publish(MadeDataSet made, Path folder, PrintWriter said)
      throws IOException, DataFormatException {
    try (StagedDirectory staged = StagedDirectory.beside(folder)) {
      made.write(staged.path());
      // What is written can be diagnosed, or is not left behind.
      new DataSetFolder(staged.path()).read();
      staged.publish();
    }
    said.println(made.readings().size() + " readings, written to " + folder);
  }

  /** {@code simbad dataset grid}. */
  @Command(
      name = "grid",
      description = {
        "Make a data set of simulated readings round an obstacle.",
        "Its threshold table decides what is heard. The scene believes Simbad's original "
            + "sensor: one range of 2.5 m for all bearings."
      },
      footer = {"", "Example: simbad dataset grid angle --out angle-against-uniform"})
  static final class Grid extends Maker {
    @Parameters(paramLabel = "OBSTACLE", description = ObstacleArgument.MEANING)
    private String obstacle = "";

    @Option(
        names = "--seed",
        paramLabel = "N",
        description = "Seed of the sensor's scatter. Default: ${DEFAULT-VALUE}.")
    private long seed = 1;

    @Option(
        names = "--sensor-file",
        paramLabel = "FILE",
        description = "The sensor's file. Default: data/sensors/srf04.json.")
    private @Nullable Path sensorFile;

    @Override
    protected void run() throws Exception {
      SonarSpec sonar = sensorFile == null ? Catalogue.srf04() : SensorFile.read(sensorFile);
      publish(TableGrid.of(ObstacleArgument.parse(obstacle), sonar, new SplittableRandom(seed)));
    }
  }

  /** {@code simbad dataset ladder}. */
  @Command(
      name = "ladder",
      description = {
        "Read a log of an HC-SR04 in front of a board at known distances (a ladder).",
        "Its columns are true_cm and reading_cm, and set and note if --set or --skip "
            + "names them. Assumptions: docs/guide/diagnose.md."
      },
      footer = {
        "",
        "Example: simbad dataset ladder data/logs/hcsr04-ladders/ladders.csv --set hankb"
            + " --sound-speed 335.28 --out hankb"
      })
  static final class Ladder extends Maker {
    @Parameters(paramLabel = "LOG.csv", description = "The log.")
    private Path log = Path.of("");

    @Option(
        names = "--set",
        paramLabel = "NAME",
        description = "Take only the rows with this value in column set. Default: all rows.")
    private @Nullable String set;

    @Option(
        names = "--skip",
        paramLabel = "NOTE",
        description = "Leave out the rows with this value in column note. Default: none.")
    private @Nullable String skip;

    @Option(
        names = "--sound-speed",
        paramLabel = "M_PER_S",
        description =
            "The speed of sound that the log's author computed ranges with. Default: "
                + "${DEFAULT-VALUE} (58 us/cm).")
    private double soundSpeedMPerS = 344.83;

    @Override
    protected void run() throws Exception {
      if (!(soundSpeedMPerS >= 100 && soundSpeedMPerS <= 2000)) {
        throw wrongUsage("--sound-speed: " + soundSpeedMPerS + " is not in [100, 2000] m/s");
      }
      publish(
          LadderLog.read(
              log,
              new LadderLog.Rows(Optional.ofNullable(set), Optional.ofNullable(skip)),
              soundSpeedMPerS));
    }
  }

  /** {@code simbad dataset plotter}. */
  @Command(
      name = "plotter",
      description = {
        "Read a log of a MaxBotix sensor on a pen plotter in front of a ball.",
        "Its columns are x, y (mm) and ultra (cm). Assumptions: docs/guide/diagnose.md."
      },
      footer = {
        "",
        "Example: simbad dataset plotter data/logs/mb1213-apple-grid/apple190_backdrop400.csv"
            + " --ball 88,76 --distance 190 --backdrop 400 --out apple190"
      })
  static final class Plotter extends Maker {
    @Parameters(paramLabel = "LOG.csv", description = "The log.")
    private Path log = Path.of("");

    @Option(
        names = "--ball",
        paramLabel = "X,Y",
        split = ",",
        required = true,
        description = "The ball's place on the plotter, mm.")
    private double[] ball = {};

    @Option(
        names = "--distance",
        paramLabel = "MM",
        required = true,
        description = "Distance from the plotter's plane to the ball.")
    private double distanceMm;

    @Option(
        names = "--backdrop",
        paramLabel = "MM",
        description =
            "Distance from the plotter's plane to the board behind the ball. Default: no "
                + "board.")
    private @Nullable Double backdropMm;

    @Override
    protected void run() throws Exception {
      if (ball.length != 2) {
        throw wrongUsage("--ball: expected X,Y in millimetres, such as 88,76");
      }
      OptionalDouble backdrop =
          backdropMm == null
              ? OptionalDouble.empty()
              : OptionalDouble.of(length("--backdrop", backdropMm));
      publish(
          PlotterLog.read(
              log,
              new PlotterLog.Setup(
                  length("--ball", ball[0]),
                  length("--ball", ball[1]),
                  length("--distance", distanceMm),
                  backdrop)));
    }

    private double length(String option, double mm) {
      if (!(mm >= 0 && mm <= 1e5)) {
        throw wrongUsage(option + ": " + mm + " is not in [0, 100000] mm");
      }
      return mm;
    }
  }
}
