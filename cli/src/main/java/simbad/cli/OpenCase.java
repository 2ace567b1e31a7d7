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
 * @param open contents of scene, readings and reference, by the files' names
 * @param later contents of what it sees when it has diagnosed: the rows to predict
 */
record OpenCase(String id, TreeMap<String, byte[]> open, TreeMap<String, byte[]> later)
    implements Serializable {
  static final String ROWS = "rows.csv";
  private static final List<String> OPEN = List.of("scene.json", "readings.csv", "reference.csv");

  /** Reads a case of a world's folder. */
  static OpenCase read(Path world, String id) throws IOException {
    TreeMap<String, byte[]> open = new TreeMap<>();
    for (String name : OPEN) {
      Path file = world.resolve("cases").resolve(id).resolve(name);
      if (Files.isRegularFile(file)) {
        open.put(name, Files.readAllBytes(file));
      }
    }
    TreeMap<String, byte[]> later = new TreeMap<>();
    later.put(ROWS, Files.readAllBytes(world.resolve("rows").resolve(id).resolve(ROWS)));
    return new OpenCase(id, open, later);
  }
}
