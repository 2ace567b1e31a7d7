package simbad.cli;

import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import simbad.experiments.run.RunSettings;
import simbad.obstacles.Catalogue;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SensorFile;
import simbad.sonar.scene.SonarSpec;

/** What drives round an obstacle: the robot's speed and the figures of its sonar. */
final class DriveOptions {
  @Option(
      names = "--sensor-file",
      paramLabel = "FILE",
      description = "The sensor's file. Default: data/sensors/srf04.json.")
  private @Nullable Path sensorFile;

  @Option(
      names = "--speed",
      paramLabel = "M_PER_S",
      description = "Speed of the robot. Default: ${DEFAULT-VALUE}.")
  private double speedMPerS = RunSettings.THESIS_SPEED_M_PER_S;

  /** Returns the speed in metres per second, and refuses one that no run takes. */
  double speedMPerS(Subcommand command) {
    if (!(speedMPerS > 0 && speedMPerS <= RunSettings.GREATEST_SPEED_M_PER_S)) {
      throw command.wrongUsage(
          "--speed: "
              + speedMPerS
              + " is not in (0, "
              + RunSettings.GREATEST_SPEED_M_PER_S
              + "] m/s");
    }
    return speedMPerS;
  }

  SonarSpec sonar() throws DataFormatException {
    return sensorFile == null ? Catalogue.srf04() : SensorFile.read(sensorFile);
  }
}
