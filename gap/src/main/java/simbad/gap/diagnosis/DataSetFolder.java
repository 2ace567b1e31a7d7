package simbad.gap.diagnosis;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ReadingsFile;
import simbad.sonar.format.SceneFile;
import simbad.sonar.format.Sha256;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorPoses;
import simbad.sonar.sensing.ReadingRow;

/**
 * A folder with a gap data set: scene.json, readings.csv and, where there is one, reference.csv.
 */
public final class DataSetFolder {
  /** What the simulator believes. */
  public static final String SCENE = "scene.json";

  /** What was really read. */
  public static final String READINGS = "readings.csv";

  /** What was read while the simulation was trusted. */
  public static final String REFERENCE = "reference.csv";

  /** All that a data set, of sensing or of motion, may be made of. */
  private static final List<String> FILES =
      List.of(
          SCENE,
          READINGS,
          REFERENCE,
          "robot.json",
          "commands.csv",
          "track.csv",
          "reference-commands.csv",
          "reference-track.csv");

  private final Path folder;

  /**
   * Names a folder.
   *
   * @param folder that need not exist yet
   */
  public DataSetFolder(Path folder) {
    this.folder = folder;
  }

  /**
   * Returns the folder's own name, whatever path leads there.
   *
   * @throws DataFormatException for the root of the file system, which has none
   */
  public String name() throws DataFormatException {
    Path name = folder.toAbsolutePath().normalize().getFileName();
    if (name == null) {
      throw DataFormatException.inFile(folder, "has no name of its own, expected a data set");
    }
    return name.toString();
  }

  /**
   * Reads the data set; rows have the poses of the sensor before the scene as it stands.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public DataSet read() throws DataFormatException {
    require();
    Path reference = folder.resolve(REFERENCE);
    SensingSetup setup = SceneFile.read(folder.resolve(SCENE));
    return new DataSet(
        name(),
        setup,
        rows(folder.resolve(READINGS), setup),
        Files.exists(reference) ? rows(reference, setup) : List.of());
  }

  /**
   * Checks that the folder is there.
   *
   * @throws DataFormatException if it is not, or is a file
   */
  public void require() throws DataFormatException {
    if (!Files.exists(folder)) {
      throw DataFormatException.inFile(folder, "no such folder");
    }
    if (!Files.isDirectory(folder)) {
      throw DataFormatException.inFile(
          folder, "is not a folder, expected one with " + SCENE + " and " + READINGS);
    }
  }

  private List<ReadingRow> rows(Path file, SensingSetup setup) throws DataFormatException {
    List<ReadingRow> rows = ReadingsFile.read(file, SceneFile.format(folder.resolve(SCENE)));
    if (rows.isEmpty()) {
      throw DataFormatException.inFile(file, "has no rows, expected readings");
    }
    Optional<String> problem = SensorPoses.problem(setup, rows);
    if (problem.isPresent()) {
      throw DataFormatException.inFile(file, problem.get());
    }
    return SensorPoses.of(setup, rows);
  }

  /**
   * Returns the SHA-256 of every file of the data set, by its name.
   *
   * @throws IOException if one cannot be read
   */
  public Map<String, String> sha256() throws IOException {
    Map<String, String> hashes = new LinkedHashMap<>();
    for (String name : FILES) {
      Path file = folder.resolve(name);
      if (Files.exists(file)) {
        hashes.put(name, Sha256.hex(Files.readAllBytes(file)));
      }
    }
    return hashes;
  }
}
