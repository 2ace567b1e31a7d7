package simbad.studio.folders;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import simbad.sonar.format.DataFormatException;

/** The traces that were last looked at: one is zoomed into without its file being read again. */
final class Traces {
  /** Two runs that are compared, and two before. */
  private static final int KEPT = 4;

  private final Map<String, Map<String, DrivenWay>> known = new LinkedHashMap<>(16, 0.75f, true);

  /**
   * Reads the traces round an obstacle, by sensor.
   *
   * @param file trace.csv
   * @param stamp another one for a file that was made anew
   * @throws DataFormatException naming file, line and field of the first fault
   */
  Map<String, DrivenWay> of(Path file, String stamp) throws DataFormatException {
    String key = file + "@" + stamp;
    Map<String, DrivenWay> before = known.get(key);
    if (before != null) {
      return before;
    }
    Map<String, DrivenWay> traces = new LinkedHashMap<>();
    Rows.read(
        file,
        row ->
            traces
                .computeIfAbsent(row.text("sensor"), name -> new DrivenWay())
                .add(row.number("x_m"), row.number("z_m")));
    known.put(key, traces);
    if (known.size() > KEPT) {
      known.remove(known.keySet().iterator().next());
    }
    return traces;
  }

  /** Writes what lies in a box, in pieces by sensor. */
  static void write(Map<String, DrivenWay> traces, DrivenWay.Box box, ObjectNode root) {
    ObjectNode all = root.putObject("traces");
    traces.forEach((sensor, trace) -> trace.write(box, all.putArray(sensor)));
  }
}
