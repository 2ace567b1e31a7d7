package simbad.experiments.batch;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleFiles;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.ObstacleTypeProvider;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.format.SceneFile;
import simbad.sonar.scene.SensingSetup;

/** Reads what robots shall circle: obstacles alone, then scenes. */
final class SceneList {
  static final String OBSTACLES = "obstacles";
  static final String SCENES = "scenes";
  private static final String TABLE = ".csv";

  private SceneList() {}

  static List<BatchScene> read(BatchSpec spec, InputPlace place) throws DataFormatException {
    List<BatchScene> scenes = new ArrayList<>();
    for (int i = 0; i < spec.obstacles().size(); i++) {
      JsonInput where = spec.obstacles().get(i);
      scenes.add(BatchScene.alone(obstacle(where, i + 1, place)));
    }
    for (int i = 0; i < spec.scenes().size(); i++) {
      scenes.add(scene(spec.scenes().get(i), i + 1, place));
    }
    return scenes;
  }

  /**
   * The types that are part of the program or of a jar beside it. Those in a folder of one's own
   * are named by their files, so that a batch can keep copies.
   */
  static Optional<ObstacleType> known(String name) {
    Optional<ObstacleType> shipped = Catalogue.find(name);
    return shipped.isPresent()
        ? shipped
        : ServiceLoader.load(ObstacleTypeProvider.class).stream()
            .flatMap(provider -> provider.get().types().stream())
            .filter(type -> type.name().equals(name))
            .findFirst();
  }

  private static ObstacleType obstacle(JsonInput where, int position, InputPlace place)
      throws DataFormatException {
    Optional<ObstacleType> known = known(where.text());
    if (known.isPresent()) {
      return known.get();
    }
    Path file = place.of(OBSTACLES, position, InputPlace.name(where, where.text()));
    if (Files.notExists(file)) {
      throw where.isNot(
          "one of "
              + Catalogue.shipped().stream()
                  .map(ObstacleType::name)
                  .collect(Collectors.joining(", "))
              + ", a table (*"
              + TABLE
              + "), or a folder with outline and table; there is no "
              + file);
    }
    return ObstacleFiles.read(file);
  }

  private static BatchScene scene(JsonInput where, int position, InputPlace place)
      throws DataFormatException {
    Path name = InputPlace.name(where, where.text());
    SensingSetup setup = SceneFile.read(place.of(SCENES, position, name));
    if (setup.scene().obstacles().isEmpty()) {
      throw where.fault("has no obstacle, but a robot needs one to circle");
    }
    return BatchScene.of(String.valueOf(name.normalize().getFileName()), setup);
  }
}
