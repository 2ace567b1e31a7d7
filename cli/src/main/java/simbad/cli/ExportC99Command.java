package simbad.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.export.SonarHeader;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SensorFile;
import simbad.sonar.format.TextFile;
import simbad.sonar.scene.SonarSpec;

/** {@code simbad export c99}. */
@Command(
    name = "c99",
    description = {
      "Write what a sonar reads of an obstacle as one C99 header without allocation: the rule of"
          + " detection shadows in whole numbers (no float, under 2 kB on an AVR) and in floats.",
      "The level model and diagnoses cannot be exported; they are refused. More:"
          + " docs/guide/export.md."
    },
    footer = {
      "",
      "Example: simbad export c99 angle --out angle.h",
      "Example: simbad export c99 my-table.csv --name post --out post.h"
    })
final class ExportC99Command extends Subcommand {
  private static final String MODEL = "model.json";

  @Parameters(paramLabel = "OBSTACLE", description = ObstacleArgument.MEANING)
  private String obstacle = "";

  @Option(names = "--out", paramLabel = "FILE", required = true, description = "A new file, *.h.")
  private Path file = Path.of("");

  @Option(
      names = "--name",
      paramLabel = "WORD",
      defaultValue = "sonar",
      description =
          "What all names in the header begin with: small letters, digits, underscores. Default:"
              + " ${DEFAULT-VALUE}.")
  private String name = "";

  @Option(
      names = "--sensor-file",
      paramLabel = "FILE",
      description =
          "File of the sensor, whose cone and range are used. Default: data/sensors/srf04.json.")
  private @Nullable Path sensorFile;

  @Override
  protected void run() throws Exception {
    if (Files.exists(Path.of(obstacle).resolve(MODEL))) {
      throw DataFormatException.inArgument(
          "OBSTACLE '" + obstacle + "'",
          "is a diagnosis: its effects have no form in C, expected an obstacle (simbad table types)");
    }
    ObstacleType type = ObstacleArgument.parse(obstacle);
    SonarSpec sensor = sensorFile == null ? Catalogue.srf04() : SensorFile.read(sensorFile);
    OutputFile.refuseExisting(file);
    TextFile.create(file, header(type, sensor).text(BuildVersion.text()));
    out().println("written to " + file);
  }

  private SonarHeader header(ObstacleType type, SonarSpec sensor) throws DataFormatException {
    try {
      return new SonarHeader(type, sensor, name);
    } catch (IllegalArgumentException e) {
      throw DataFormatException.inArgument(obstacle, String.valueOf(e.getMessage()));
    }
  }
}
