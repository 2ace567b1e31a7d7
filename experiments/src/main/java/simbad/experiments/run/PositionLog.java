package simbad.experiments.run;

import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;
import simbad.sonar.shape.ThresholdTable;

/**
 * Positions that a robot's program logged with {@code java.util.logging}, as those of Kranz (2014),
 * figure 4.16: {@code INFO: 0.025,-2.5} is x and z in metres, the obstacle at the origin.
 *
 * <p>Any level's name in capital letters will do. Other lines, such as the logger's with date and
 * class, are passed over and counted.
 *
 * @param trace the positions; in the log every one counts as on the edge, and nothing is known of
 *     what was heard
 * @param otherLines how many lines hold no position
 */
public record PositionLog(Trace trace, int otherLines) {
  private static final String NUMBER = "([-+]?(?:\\d+\\.?\\d*(?:[eE][-+]?\\d+)?|NaN|Infinity))";
  private static final Pattern POSITION =
      Pattern.compile("\\s*\\p{Lu}+\\s*: *" + NUMBER + " *, *" + NUMBER + "\\s*");

  /** A way needs a begin and an end. */
  private static final int LEAST_POSITIONS = 2;

  /**
   * Reads a log.
   *
   * @param file text in UTF-8
   * @throws DataFormatException naming file and line if a position is further from the obstacle
   *     than any table reaches, or if there are fewer than two positions
   */
  public static PositionLog read(Path file) throws DataFormatException {
    List<String> lines = TextFile.read(file).lines().toList();
    Trace trace = new Trace(Circuit.STEP_S);
    for (int i = 0; i < lines.size(); i++) {
      Matcher match = POSITION.matcher(lines.get(i));
      if (match.matches()) {
        add(
            trace,
            coordinate(file, i + 1, "x", match.group(1)),
            coordinate(file, i + 1, "z", match.group(2)));
      }
    }
    if (trace.size() < LEAST_POSITIONS) {
      throw DataFormatException.inFile(
          file,
          trace.size()
              + " lines with a position, expected at least "
              + LEAST_POSITIONS
              + " such as INFO: 0.025,-2.5");
    }
    return new PositionLog(trace, lines.size() - trace.size());
  }

  private static double coordinate(Path file, int line, String field, String text)
      throws DataFormatException {
    double metres = Double.parseDouble(text);
    if (!(Math.abs(metres) <= ThresholdTable.GREATEST_THRESHOLD_M)) {
      throw DataFormatException.inField(
          file,
          line,
          field,
          "found "
              + text
              + ", expected metres from the obstacle in [-"
              + ThresholdTable.GREATEST_THRESHOLD_M
              + ", "
              + ThresholdTable.GREATEST_THRESHOLD_M
              + "]");
    }
    return metres;
  }

  private static void add(Trace trace, double xM, double zM) {
    trace.add(xM, zM, 0, false);
    if (trace.size() == 1) {
      trace.edgeFound();
    }
  }

  /**
   * Compares the positions with a table.
   *
   * @param table of the obstacle at the origin
   */
  public TraceErrors errors(ThresholdTable table) {
    return TraceErrors.of(trace, table);
  }
}
