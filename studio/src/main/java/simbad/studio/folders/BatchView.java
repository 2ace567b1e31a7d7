package simbad.studio.folders;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import simbad.sonar.format.DataFormatException;

/** A batch's folder: its rows of results. */
final class BatchView {
  /** More dots than that are one blot. */
  private static final int MOST = 20_000;

  private BatchView() {}

  /**
   * Adds what a batch left.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  static void add(Path folder, ObjectNode root) throws DataFormatException {
    root.set("batch", JsonText.read(Shelf.file(folder, "batch.json")));
    ArrayNode columns = root.putArray("columns");
    ArrayNode rows = root.putArray("rows");
    int[] all = {0};
    Rows.read(
        Shelf.file(folder, "results.csv"),
        row -> {
          if (all[0] == 0) {
            row.fields().getHeader().forEach(columns::add);
          }
          if (all[0]++ < MOST) {
            ArrayNode list = rows.addArray();
            row.fields().getFields().forEach(list::add);
          }
        });
    root.put("all_rows", all[0]);
  }
}
