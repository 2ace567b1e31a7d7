package simbad.experiments.bench;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.CapturedReadings;
import simbad.bench.capture.Journal;
import simbad.bench.capture.Ranging;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsWriter;
import simbad.sonar.format.SceneWriter;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.TableDetection;

/**
 * The folder of a capture: the journal, and beside it the data set that is made of it.
 *
 * @param path of the folder
 */
public record CaptureFolder(Path path) {
  private static final String JOURNAL = "journal.txt";

  /** Returns where the journal is. */
  public Path journal() {
    return path.resolve(JOURNAL);
  }

  /**
   * Begins a capture in a folder that is not there yet, or empty.
   *
   * @param settings how it is begun
   * @throws IOException if something is there, or nothing can be written
   */
  public Journal begin(CaptureSettings settings) throws IOException {
    requireFree();
    Files.createDirectories(path);
    return Journal.create(journal(), settings.entry());
  }

  /**
   * Checks that a capture can begin here.
   *
   * @throws IOException if something is there, but for an empty folder or one in which a capture
   *     was ended before it had begun
   */
  public void requireFree() throws IOException {
    if (Files.exists(path) && !Files.isDirectory(path)) {
      throw new FileAlreadyExistsException(path.toString());
    }
    if (Files.exists(path)) {
      try (Stream<Path> entries = Files.list(path)) {
        if (entries.anyMatch(entry -> !entry.equals(Journal.beginning(journal())))) {
          throw new FileAlreadyExistsException(path.toString());
        }
      }
    }
  }

  /**
   * Reads the journal, whose readings may be asked for then.
   *
   * @throws DataFormatException naming the file and the line
   */
  public CapturedReadings read() throws DataFormatException {
    return CapturedReadings.of(journal());
  }

  /**
   * Writes readings as a gap data set beside the journal, over the one that was there. Whole files
   * only.
   *
   * @param readings of this folder's journal
   * @param believed what the simulator expects of the obstacle
   * @param sensor the sensor's figures
   * @throws IOException if it cannot be written
   * @throws DataFormatException if the journal cannot be read
   */
  public void writeDataSet(CapturedReadings readings, ObstacleType believed, SonarSpec sensor)
      throws IOException, DataFormatException {
    WholeFile.write(
        path.resolve(DataSetFolder.READINGS),
        file -> {
          try (ReadingsWriter rows = ReadingsWriter.to(file)) {
            readings.forEach(rows::write);
          }
        });
    TextFile.write(
        path.resolve(DataSetFolder.SCENE),
        SceneWriter.text(setup(readings.settings().ranging(), believed, sensor)));
  }

  private static SensingSetup setup(Ranging ranging, ObstacleType believed, SonarSpec sensor) {
    SonarSpec spec =
        new SonarSpec(
            sensor.name(),
            sensor.coneHalfAngleRad(),
            sensor.minRangeM(),
            sensor.maxRangeM(),
            sensor.mountHeightM(),
            ranging.soundSpeedMPerS(),
            ranging.stepM(),
            sensor.rangeNoiseM(),
            sensor.missRate(),
            sensor.edgeWidthM(),
            sensor.updatePeriodS());
    Obstacle obstacle =
        new Obstacle(
            believed.name(),
            new Placement(0, 0, 0),
            believed.outline(),
            new TableDetection(believed.thresholds().table()));
    return new SensingSetup(spec, new Scene(List.of(obstacle)), spec.maxRangeM());
  }
}
