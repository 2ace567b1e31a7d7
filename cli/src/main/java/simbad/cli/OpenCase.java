package simbad.cli;

import java.io.IOException;
import java.io.Serializable;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeMap;

/**
 * What a diagnosis may see of a withheld check's case.
 *
 * @param id its name
 * @param open contents of scene, readings and reference, or of robot, commands and track with their
 *     reference, by the files' names
 * @param later contents of what it sees when it has diagnosed: the rows, or the drive, to predict
 */
record OpenCase(String id, TreeMap<String, byte[]> open, TreeMap<String, byte[]> later)
    implements Serializable {
  static final String ROWS = "rows.csv";
  private static final String TRACK = "track.csv";
  private static final List<String> OPEN =
      List.of(
          "scene.json",
          "readings.csv",
          "reference.csv",
          "robot.json",
          "commands.csv",
          TRACK,
          "reference-commands.csv",
          "reference-track.csv");

  /** Reads a case of a world's folder. */
  static OpenCase read(Path world, String id) throws IOException {
    TreeMap<String, byte[]> open = contents(world.resolve("cases").resolve(id));
    Path rows = world.resolve("rows").resolve(id);
    TreeMap<String, byte[]> later = new TreeMap<>();
    if (open.containsKey(TRACK)) {
      later.putAll(contents(rows));
    } else {
      later.put(ROWS, Files.readAllBytes(rows.resolve(ROWS)));
    }
    return new OpenCase(id, open, later);
  }

  private static TreeMap<String, byte[]> contents(Path folder) throws IOException {
    TreeMap<String, byte[]> contents = new TreeMap<>();
    for (String name : OPEN) {
      Path file = folder.resolve(name);
      if (Files.isRegularFile(file)) {
        contents.put(name, Files.readAllBytes(file));
      }
    }
    return contents;
  }

  /** True for a robot's drive, where a folder is predicted and no file of rows. */
  boolean isMotion() {
    return open.containsKey(TRACK);
  }
}
