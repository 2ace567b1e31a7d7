package simbad.blindworld.generate;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import simbad.blindworld.baseline.DataSet;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.Decimals;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.world.Recording;

/**
 * Rows that somebody wants read, as they stand in a file: whoever adds what is read to them has the
 * very poses that the world heard.
 *
 * @param lines each row's own text
 * @param recording the same rows, in the same order
 */
record AskedRows(List<String> lines, Recording recording) {

  private static final List<String> HEADER =
      List.of("run", "sensor", "t_s", "x_m", "z_m", "heading_deg");

  /**
   * Reads a file with the columns of readings.csv less the last.
   *
   * @throws FormatException naming file, line and field
   */
  static AskedRows read(Path file) throws IOException, FormatException {
    String text = Files.readString(file);
    Csv csv = Csv.parse(file.toString(), text);
    if (!csv.header().equals(HEADER)) {
      throw new FormatException(
          "%s, line 1: '%s', expected %s"
              .formatted(file, String.join(",", csv.header()), String.join(",", HEADER)));
    }
    List<String> lines = text.lines().filter(line -> !line.isBlank()).skip(1).toList();
    return new AskedRows(lines, DataSet.rows(csv));
  }

  /** The rows as readings.csv has them; an infinite reading is a no-echo, an empty field. */
  String with(double[] rangesM) {
    StringBuilder text = new StringBuilder(String.join(",", HEADER)).append(",range_m\n");
    for (int row = 0; row < rangesM.length; row++) {
      text.append(lines.get(row)).append(',');
      if (rangesM[row] < Double.POSITIVE_INFINITY) {
        Decimals.append(text, rangesM[row], 4);
      }
      text.append('\n');
    }
    return text.toString();
  }
}
