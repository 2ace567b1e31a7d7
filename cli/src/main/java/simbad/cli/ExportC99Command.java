package simbad.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.export.FoldedDiagnosis;
import simbad.experiments.export.LevelHeader;
import simbad.experiments.export.SonarHeader;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SceneFile;
import simbad.sonar.format.SensorFile;
import simbad.sonar.format.TextFile;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.predict.ModelFile;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/** {@code simbad export c99}. */
@Command(
    name = "c99",
    description = {
      "Write what a sonar reads from an obstacle as one C99 header.",
      "It holds the rule of detection shadows, or the level model, in whole numbers "
          + "(no float; under 2 kB on an AVR) and in floats. It allocates no memory.",
      "Given a diagnosis' folder, it includes the diagnosed effects. An effect that "
          + "cannot be written in C is refused by name. Guide: docs/guide/export.md."
    },
    footer = {
      "",
      "Example: simbad export c99 angle --out angle.h",
      "Example: simbad export c99 my-table.csv --name post --out post.h",
      "Example: simbad export c99 diagnoses/my-log --out sonar.h"
    })
final class ExportC99Command extends Subcommand {
  private static final String MODEL = "model.json";
  private static final String LEVEL = "level";

  @Parameters(
      paramLabel = "OBSTACLE|DIAGNOSIS",
      description = ObstacleArgument.MEANING + " Or the folder of a diagnosis.")
  private String obstacle = "";

  @Option(names = "--out", paramLabel = "FILE", required = true, description = "A new file, *.h.")
  private Path file = Path.of("");

  @Option(
      names = "--name",
      paramLabel = "WORD",
      defaultValue = "sonar",
      description =
          "Beginning of all names in the header: small letters, digits, underscores. "
              + "Default: ${DEFAULT-VALUE}.")
  private String name = "";

  @Option(
      names = "--sensor-file",
      paramLabel = "FILE",
      description =
          "The sensor's file; its cone and range are used. Default: " + "data/sensors/srf04.json.")
  private @Nullable Path sensorFile;

  @Option(
      names = "--model",
      paramLabel = "MODEL",
      defaultValue = "shadow",
      description =
          "The model that decides what is heard: shadow or level. Default: ${DEFAULT-VALUE}.")
  private String model = "";

  @Option(
      names = "--obstacle",
      paramLabel = "LABEL",
      description = "The obstacle of a diagnosis' scene; needed if there are several.")
  private String label = "";

  @Override
  protected void run() throws Exception {
    requireName();
    OutputFile.refuseExisting(file);
    if (!model.equals("shadow") && !model.equals(LEVEL)) {
      throw wrongUsage("--model: '" + model + "' is not one of shadow, level");
    }
    String header;
    try {
      header = Files.exists(Path.of(obstacle).resolve(MODEL)) ? ofDiagnosis() : ofObstacle();
    } catch (IllegalArgumentException e) {
      String problem = String.valueOf(e.getMessage());
      if (problem.startsWith("obstacle = ")) {
        throw wrongUsage(e);
      }
      throw DataFormatException.inArgument(obstacle, problem);
    }
    TextFile.create(file, header);
    out().println("written to " + file);
  }

  private void requireName() {
    try {
      SonarHeader.requireName(name);
    } catch (IllegalArgumentException e) {
      throw wrongUsage(e);
    }
  }

  private String ofObstacle() throws Exception {
    if (!label.isEmpty()) {
      throw wrongUsage(
          "--obstacle: '"
              + label
              + "' is for the folder of a diagnosis, whose scene has labels; "
              + obstacle
              + " is none");
    }
    ObstacleType type = ObstacleArgument.parse(obstacle);
    SonarSpec sensor = sensorFile == null ? Catalogue.srf04() : SensorFile.read(sensorFile);
    return model.equals(LEVEL)
        ? new LevelHeader(type, sensor, name).text(BuildVersion.text())
        : new SonarHeader(type, sensor, name).text(BuildVersion.text());
  }

  private String ofDiagnosis() throws Exception {
    if (sensorFile != null || model.equals(LEVEL)) {
      throw wrongUsage(
          (sensorFile == null ? "--model" : "--sensor-file") + ": a diagnosis brings its own");
    }
    Path folder = Path.of(obstacle);
    SensingSetup setup = SceneFile.read(folder.resolve("scene.json"));
    FittedModel fitted = ModelFile.read(folder.resolve(MODEL), setup);
    FoldedDiagnosis folded = new FoldedDiagnosis(fitted, label);
    return folded.isLevel()
        ? new LevelHeader(folded, name).text(BuildVersion.text())
        : new SonarHeader(folded, name).text(BuildVersion.text());
  }
}
