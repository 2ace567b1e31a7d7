package simbad.experiments.report;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.StringWriter;
import simbad.experiments.run.Trace;

/** Traces as rows of csv: a row per step, metres in the obstacle's frame, degrees, seconds. */
public final class TraceTable {
  private TraceTable() {}

  /**
   * Returns one trace as the text of a file.
   *
   * @param sensor that the robot drove by
   * @param trace where it was
   */
  public static String text(String sensor, Trace trace) {
    StringWriter text = new StringWriter();
    CsvWriter csv = CsvWriter.builder().bufferSize(0).lineDelimiter(LineDelimiter.LF).build(text);
    writeHeader(csv);
    writeRows(csv, sensor, trace);
    return text.toString();
  }

  static void writeHeader(CsvWriter csv) {
    csv.writeRecord("sensor", "step", "t_s", "x_m", "z_m", "heading_deg", "heard", "on_edge");
  }

  static void writeRows(CsvWriter csv, String sensor, Trace trace) {
    for (int i = 0; i < trace.size(); i++) {
      csv.writeRecord(
          sensor,
          Integer.toString(i + 1),
          RunFiles.fixed(trace.timeS(i), 2),
          RunFiles.fixed(trace.xM(i), 6),
          RunFiles.fixed(trace.zM(i), 6),
          RunFiles.fixed(Math.toDegrees(trace.headingRad(i)), 3),
          trace.heard(i) ? "1" : "0",
          i >= trace.firstOnEdge() ? "1" : "0");
    }
  }
}
