package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

/** A run's folder: per obstacle its table, what each sensor was off by at each bearing, traces. */
final class RunView {
  private final Path folder;
  private final Traces traces;
  private final String stamp;

  /**
   * Names a run.
   *
   * @param folder of the run
   * @param traces that were read before
   * @param stamp another one for a folder that was made anew
   */
  RunView(Path folder, Traces traces, String stamp) {
    this.folder = folder;
    this.traces = traces;
    this.stamp = stamp;
  }

  /**
   * Adds what a run left.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  void add(ObjectNode root) throws DataFormatException {
    JsonNode errors = JsonText.read(Shelf.file(folder, "errors.json"));
    root.set("errors", errors);
    Set<String> obstacles = new LinkedHashSet<>();
    errors.path("results").forEach(result -> obstacles.add(result.path("obstacle").asText()));
    ArrayNode list = root.putArray("obstacles");
    for (String obstacle : obstacles) {
      add(obstacle, list.addObject());
    }
  }

  /**
   * Reads the traces round one of its obstacles, by sensor.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  Map<String, DrivenWay> trace(String obstacle) throws DataFormatException {
    return traces.of(Shelf.file(own(obstacle), "trace.csv"), stamp);
  }

  /** The name stands in a file: it may be anything. */
  private Path own(String obstacle) throws DataFormatException {
    Shelf shelf = Shelf.of(folder);
    return shelf.folder(obstacle);
  }

  private void add(String obstacle, ObjectNode node) throws DataFormatException {
    Path own = own(obstacle);
    node.put("name", obstacle);
    TableDocument document = TableFile.read(Shelf.file(own, "table.csv"));
    node.put("provenance", document.provenanceWord());
    document.header("pings").ifPresent(pings -> node.put("pings", pings));
    addTable(document, node);
    addOutline(obstacle, node);
    ObjectNode errors = node.putObject("errors_m");
    Rows.read(
        Shelf.file(own, "radial.csv"),
        row -> {
          ArrayNode list = errors.withArray(row.text("sensor"));
          if (row.text("mean_abs_error_m").isEmpty()) {
            list.addNull();
          } else {
            list.add(row.number("mean_abs_error_m"));
          }
        });
    Traces.write(trace(obstacle), DrivenWay.Box.ALL, node);
  }

  private static void addTable(TableDocument document, ObjectNode node) {
    ArrayNode table = node.putArray("table");
    int size = document.table().size();
    for (int i = 0; i < size; i++) {
      int at = i;
      ArrayNode row = table.addArray().add(i * 360.0 / size).add(document.table().valueM(i));
      document.band().ifPresent(band -> row.add(band.low().valueM(at)).add(band.high().valueM(at)));
    }
  }

  /** Of an obstacle that is in nobody's catalogue any more only the table is known. */
  private void addOutline(String obstacle, ObjectNode node) throws DataFormatException {
    ArrayNode parts = node.putArray("parts");
    for (ObstacleType type : Catalogue.findAny(obstacle).stream().toList()) {
      type.parts().forEach(part -> addCorners(part, parts.addArray()));
    }
  }

  static void addCorners(Outline part, ArrayNode list) {
    for (Point corner : part.corners()) {
      list.addArray().add(corner.xM()).add(corner.zM());
    }
  }
}
