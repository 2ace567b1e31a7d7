package simbad.cli;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.report.TableName;
import simbad.experiments.run.PositionLog;
import simbad.experiments.run.TraceErrors;
import simbad.experiments.table.Reconstruction;
import simbad.figures.report.TablePicture;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableDocument;
import simbad.sonar.shape.ThresholdTable;

/** {@code simbad table}: threshold tables. */
@Command(
    name = "table",
    description = "Show, plot, compare, predict and import threshold tables.",
    subcommands = {
      TableCommand.Types.class,
      TableCommand.Show.class,
      TableCommand.Plot.class,
      TableCompareCommand.class,
      TablePredictCommand.class,
      TableCalibrateCommand.class,
      TableImportCommand.class,
      TableCommand.Reconstruct.class
    },
    footer = {"", "Example: simbad table show angle"})
final class TableCommand extends CommandGroup {

  /** {@code simbad table types}. */
  @Command(
      name = "types",
      description = {
        "List the obstacle types: those that come with the project, those of jars (service"
            + " simbad.obstacles.ObstacleTypeProvider), those in the folder SIMBAD_OBSTACLES."
      },
      footer = {"", "Example: simbad table types"})
  static final class Types extends Subcommand {
    @Override
    protected void run() throws Exception {
      for (ObstacleType type : Catalogue.all()) {
        TableDocument table = type.thresholds();
        out()
            .println(
                TableName.of(type) + ": " + table.header("object").orElse("object not stated"));
      }
    }
  }

  /** {@code simbad table show}. */
  @Command(
      name = "show",
      description = "Print what a table's file says about it, and its range.",
      footer = {"", "Example: simbad table show my-table.csv"})
  static final class Show extends Subcommand {
    @Parameters(paramLabel = "OBSTACLE", description = ObstacleArgument.MEANING)
    private String obstacle = "";

    @Override
    protected void run() throws Exception {
      ObstacleType type = ObstacleArgument.parse(obstacle);
      TableDocument document = type.thresholds();
      out().println(TableName.of(type));
      document.header().forEach((key, value) -> out().println("  " + key + ": " + value));
      ThresholdTable table = document.table();
      double least = Arrays.stream(table.valuesM()).min().orElse(0);
      out()
          .printf(
              Locale.ROOT,
              "  %d bearings, every %.4g degrees; %.2f to %.2f m%n",
              table.size(),
              360.0 / table.size(),
              least,
              table.greatestM());
    }
  }

  /** {@code simbad table plot}. */
  @Command(
      name = "plot",
      description = {
        "Draw a table as a polar plot.",
        "The ending of --out says PNG or SVG. A predicted or captured table is drawn "
            + "with its uncertainty.",
        "With --log, draw a robot's logged positions over it, and print their errors."
      },
      footer = {
        "",
        "Example: simbad table plot angle --out angle.svg",
        "Example: simbad table plot angle --log AngleRobot.log --out trace.png"
      })
  static final class Plot extends Subcommand {
    @Parameters(paramLabel = "OBSTACLE", description = ObstacleArgument.MEANING)
    private String obstacle = "";

    @Option(names = "--out", paramLabel = "FILE", required = true, description = "*.png or *.svg")
    private Path file = Path.of("");

    @Option(
        names = "--log",
        paramLabel = "LOG",
        description =
            "A text file with lines such as INFO: 0.025,-2.5 (java.util.logging): x and z "
                + "in metres, the obstacle at 0,0. Other lines are ignored.")
    private @Nullable Path log;

    @Override
    protected void run() throws Exception {
      requirePicture("--out", file);
      ObstacleType type = ObstacleArgument.parse(obstacle);
      Optional<PositionLog> positions =
          log == null ? Optional.empty() : Optional.of(PositionLog.read(log));
      OutputFile.refuseExisting(file);
      OutputFile.draw(
          positions
              .map(known -> TablePicture.of(type, "trace, " + log, known.trace()))
              .orElseGet(() -> TablePicture.of(type)),
          file);
      positions.ifPresent(known -> print(known, known.errors(type.thresholds().table())));
    }

    private void print(PositionLog positions, TraceErrors errors) {
      out()
          .printf(
              Locale.ROOT,
              "%s: %d positions, %d other lines%n",
              log,
              positions.trace().size(),
              positions.otherLines());
      out()
          .printf(
              Locale.ROOT,
              "radial error: mean %s, RMS %s, max %s cm; mean distance from the edge %s cm; "
                  + "%d of %d bearings not crossed%n",
              RunSummary.centimetres(errors.meanM()),
              RunSummary.centimetres(errors.rmsM()),
              RunSummary.centimetres(errors.maxM()),
              RunSummary.centimetres(OptionalDouble.of(errors.lateralMeanM())),
              errors.unreachedBearings(),
              errors.radialM().size());
    }
  }

  /** {@code simbad table reconstruct}. */
  @Command(
      name = "reconstruct",
      description = {
        "Compute the table of the square or round obstacle from what the thesis says "
            + "about it.",
        "The thesis plots these tables but does not print their numbers. The reasoning "
            + "is in docs/decisions."
      },
      footer = {"", "Example: simbad table reconstruct square --out square-25mm.csv"})
  static final class Reconstruct extends Subcommand {
    @Parameters(paramLabel = "square|round", description = "Which obstacle.")
    private String obstacle = "";

    @Mixin private TableResult result = new TableResult();

    @Override
    protected void run() throws Exception {
      TableDocument document =
          switch (obstacle) {
            case "round" -> Reconstruction.round();
            case "square" -> Reconstruction.square(Catalogue.angleTable().table());
            default -> throw wrongUsage("'" + obstacle + "' is neither square nor round");
          };
      result.give(document, out());
    }
  }
}
