package simbad.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.table.PredictedTable;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.scattering.FittedReceiver;
import simbad.scattering.KnownThresholds;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OutlineDocument;
import simbad.sonar.format.OutlineFile;
import simbad.sonar.format.SensorFile;
import simbad.sonar.level.Air;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

/** {@code simbad table predict}. */
@Command(
    name = "predict",
    description = {
      "Predict a threshold table from a cross-section: rigid scattering at 40 kHz and the sonar equation.",
      "OUTLINE is the name of an obstacle, or a csv file with a row per corner: "
          + "x_m,z_m (or mm, cm), the axis of rotation at 0,0. The limits of the model: "
          + "docs/method/scattering.md."
    },
    footer = {
      "",
      "Example: simbad table predict my-post-outline.csv --out my-post.csv",
      "Example: simbad table predict square --temperature 5 --humidity 80"
    })
final class TablePredictCommand extends Subcommand {
  private static final double MOST_REACH_M = 0.25;
  private static final double LEAST_REACH_M = 0.001;
  private static final int MOST_BEARINGS = 3600;

  /** Each is an unknown at least; their equations take memory by the square, time by the cube. */
  private static final int MOST_CORNERS = 1000;

  @Parameters(paramLabel = "OUTLINE", description = "OUTLINE.csv, or an obstacle's name.")
  private String outline = "";

  @Option(
      names = "--temperature",
      paramLabel = "C",
      description = "Temperature of the air, degrees Celsius. Default: ${DEFAULT-VALUE}.")
  private double temperatureC = Air.ROOM.temperatureC();

  @Option(
      names = "--humidity",
      paramLabel = "PERCENT",
      description = "Relative humidity of the air. Default: ${DEFAULT-VALUE}.")
  private double humidityPercent = Air.ROOM.humidityPercent();

  @Option(
      names = "--bearings",
      paramLabel = "N",
      description = "Rows of the table. Default: ${DEFAULT-VALUE}.")
  private int bearings = KnownThresholds.BEARINGS;

  @Option(
      names = "--sensor-file",
      paramLabel = "FILE",
      description =
          "The sensor's file; its minimum and maximum range bound the table. Default: "
              + "data/sensors/srf04.json.")
  private @Nullable Path sensorFile;

  @Option(
      names = "--without-angle",
      description =
          "Use the calibration that leaves out the angle's measured table, to see how"
              + " well the angle is predicted.")
  private boolean withoutAngle;

  @Mixin private TableResult result = new TableResult();

  @Override
  protected void run() throws Exception {
    Air air = air();
    if (bearings < 3 || bearings > MOST_BEARINGS) {
      throw wrongUsage("--bearings: " + bearings + " is not in [3, " + MOST_BEARINGS + "]");
    }
    OutlineDocument section = section();
    checkSize(section);
    SonarSpec sonar = sensorFile == null ? Catalogue.srf04() : SensorFile.read(sensorFile);
    result.check();
    FittedReceiver calibration = withoutAngle ? FittedReceiver.WITHOUT_ANGLE : FittedReceiver.SRF04;
    result.give(PredictedTable.of(section, air, sonar, calibration, bearings), out());
  }

  /** The named obstacle's, that of a file, or that of a folder with one. */
  private OutlineDocument section() throws DataFormatException {
    if (ObstacleArgument.isPath(outline)) {
      Path path = Path.of(outline);
      return OutlineFile.read(Files.isDirectory(path) ? path.resolve("outline.csv") : path);
    }
    Optional<ObstacleType> known = Catalogue.findAny(outline);
    if (known.isEmpty()) {
      throw ObstacleArgument.unknown(outline);
    }
    ObstacleType type = known.get();
    return new OutlineDocument(
        type.parts(), Map.of("object", type.thresholds().header("object").orElse(type.name())));
  }

  private void checkSize(OutlineDocument section) throws DataFormatException {
    if (section.reachM() < LEAST_REACH_M || section.reachM() > MOST_REACH_M) {
      throw DataFormatException.inArgument(
          outline,
          String.format(
              Locale.ROOT,
              "reaches %.4g m from the axis, expected a post of %s to %s m",
              section.reachM(),
              LEAST_REACH_M,
              MOST_REACH_M));
    }
    int corners = section.parts().stream().mapToInt(Outline::size).sum();
    if (corners > MOST_CORNERS) {
      throw DataFormatException.inArgument(
          outline,
          "has "
              + corners
              + " corners, expected at most "
              + MOST_CORNERS
              + " for a prediction: one to half a millimetre is plenty");
    }
  }

  private Air air() {
    try {
      return new Air(temperatureC, humidityPercent);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(e);
    }
  }
}
