package simbad.experiments.batch;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import simbad.experiments.run.DiagnosedFolder;
import simbad.motion.format.DiagnosedMotion;
import simbad.motion.format.MotionFolder;
import simbad.obstacles.ObstacleFiles;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.format.TextFile;

/** Gathers the texts of all files that a spec names, by the names of their copies. */
final class InputFiles {
  static final String SENSOR_FILES = "sensor_files";

  private final InputPlace place;
  private final SortedMap<String, String> texts = new TreeMap<>();

  private InputFiles(InputPlace place) {
    this.place = place;
  }

  static SortedMap<String, String> gather(BatchSpec spec, InputPlace place)
      throws DataFormatException {
    InputFiles inputs = new InputFiles(place);
    inputs.obstacles(spec.obstacles());
    inputs.files(SceneList.SCENES, spec.scenes());
    inputs.choices(
        SensorChoice.DIMENSION, spec.sensors(), SensorChoice::folder, "scene.json", "model.json");
    inputs.choices(
        RobotChoice.DIMENSION,
        spec.robots(),
        RobotChoice::path,
        MotionFolder.ROBOT,
        DiagnosedMotion.MODEL);
    inputs.files(SENSOR_FILES, spec.sensorFiles());
    return inputs.texts;
  }

  private void obstacles(List<JsonInput> list) throws DataFormatException {
    for (int i = 0; i < list.size(); i++) {
      JsonInput where = list.get(i);
      if (SceneList.known(where.text()).isEmpty()) {
        Path name = InputPlace.name(where, where.text());
        Path path = place.of(SceneList.OBSTACLES, i + 1, name);
        String copy = InputPlace.copyName(SceneList.OBSTACLES, i + 1, name);
        String folder = Files.isDirectory(path) ? copy : copy.substring(0, copy.lastIndexOf('/'));
        for (Path file : ObstacleFiles.files(path)) {
          take(folder, file);
        }
      }
    }
  }

  private void files(String dimension, List<JsonInput> list) throws DataFormatException {
    for (int i = 0; i < list.size(); i++) {
      Path name = InputPlace.name(list.get(i), list.get(i).text());
      take(dimension + "/" + (i + 1), place.of(dimension, i + 1, name));
    }
  }

  /** What an entry of a list names; empty where it names no file. */
  private interface Naming {
    Optional<Path> path(JsonInput where) throws DataFormatException;
  }

  /** Of a diagnosis' folder only the files that a batch reads. */
  private void choices(
      String dimension, List<JsonInput> list, Naming naming, String... filesOfDiagnosis)
      throws DataFormatException {
    for (int i = 0; i < list.size(); i++) {
      Optional<Path> name = naming.path(list.get(i));
      if (name.isEmpty()) {
        continue;
      }
      Path path = place.of(dimension, i + 1, name.get());
      String copy = InputPlace.copyName(dimension, i + 1, name.get());
      if (DiagnosedFolder.in(list.get(i).text()).isEmpty()) {
        take(copy.substring(0, copy.lastIndexOf('/')), path);
        continue;
      }
      for (String file : filesOfDiagnosis) {
        take(copy, path.resolve(file));
      }
    }
  }

  private void take(String folder, Path file) throws DataFormatException {
    texts.put(folder + "/" + file.normalize().getFileName(), TextFile.read(file));
  }
}
