package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import simbad.sonar.format.DataFormatException;

/** The folder of a diagnosis of motion: what it says, and the drive that it was made of. */
final class MotionView {
  private MotionView() {}

  /**
   * Adds what a diagnosis left.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  static void add(Path folder, DataSets sets, ObjectNode root) throws DataFormatException {
    JsonNode diagnosis = JsonText.read(Shelf.file(folder, "diagnosis.json"));
    root.set("diagnosis", diagnosis);
    drive(folder, sets, root, diagnosis);
  }

  /**
   * Adds the drive where its very files are found.
   *
   * @param motion what is said of the motion, with its places
   * @throws DataFormatException naming file, line and field of the first fault
   */
  static void drive(Path folder, DataSets sets, ObjectNode root, JsonNode motion)
      throws DataFormatException {
    DataSets.Found found = sets.find(root.path("diagnosis"));
    root.put("missing", found.missing());
    if (found.folder().isPresent()) {
      DriveView.add(found.folder().get(), folder, motion, root);
    }
  }
}
