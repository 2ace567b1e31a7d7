package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.motion.format.MotionFolder;
import simbad.sonar.format.DataFormatException;

/** Finds the data set that a diagnosis was made of: by its name, and to the byte. */
final class DataSets {
  private final List<Shelf> shelves;

  /** Looks in folders and all that is in them. */
  DataSets(List<Shelf> shelves) {
    this.shelves = List.copyOf(shelves);
  }

  /**
   * What was found.
   *
   * @param folder of the data set; empty where none has the very files
   * @param missing why there is none, as a sentence without its full stop
   */
  record Found(Optional<Path> folder, String missing) {}

  /**
   * Looks for a data set.
   *
   * @param diagnosis the diagnosis' JSON
   * @throws DataFormatException if a folder cannot be read
   */
  Found find(JsonNode diagnosis) throws DataFormatException {
    String name = diagnosis.path("dataset").asText();
    JsonNode hashes = diagnosis.path("provenance").path("sha256");
    boolean named = false;
    try {
      for (Shelf shelf : shelves) {
        for (Path folder : shelf.find(candidate -> isNamed(candidate, name))) {
          named = true;
          if (isSame(folder, hashes)) {
            return new Found(Optional.of(folder), "");
          }
        }
      }
    } catch (IOException e) {
      throw DataFormatException.inFile(shelves.get(0).root(), "cannot be read: " + e.getMessage());
    }
    String missing =
        named
            ? "the data set '" + name + "' in here has other files than were diagnosed"
            : "no data set '" + name + "' is in here";
    return new Found(Optional.empty(), missing + "; --data FOLDER says where else to look");
  }

  private static boolean isNamed(Path folder, String name) {
    Path own = folder.getFileName();
    return own != null
        && own.toString().equals(name)
        && (isThere(folder, DataSetFolder.READINGS, DataSetFolder.SCENE)
            || isThere(folder, MotionFolder.TRACK, MotionFolder.COMMANDS));
  }

  private static boolean isThere(Path folder, String... files) {
    return Stream.of(files).allMatch(file -> Files.isRegularFile(folder.resolve(file)));
  }

  /** A reference that came later, or is gone, makes it another data set. */
  private static boolean isSame(Path folder, JsonNode hashes) throws IOException {
    Map<String, String> own = new DataSetFolder(folder).sha256();
    return own.size() == hashes.size()
        && own.entrySet().stream()
            .allMatch(entry -> hashes.path(entry.getKey()).asText().equals(entry.getValue()));
  }
}
