package simbad.sonar.format;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.List;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** Writes what {@link ReadingsFile} reads, rounded to what a bench can tell. */
public final class ReadingsWriter {
  private static final int DECIMALS_S = 3;
  private static final int DECIMALS_M = 4;
  private static final int DECIMALS_DEG = 3;

  private ReadingsWriter() {}

  /**
   * Returns rows with their readings as the text of a file.
   *
   * @param rows in the order of the text; milliseconds, tenths of a millimetre and thousandths of a
   *     degree are kept
   */
  public static String text(List<ReadingRow> rows) {
    return text(rows, true);
  }

  /**
   * Returns the poses of rows as the text of a file without a column for the range.
   *
   * @param rows in the order of the text
   */
  public static String posesText(List<ReadingRow> rows) {
    return text(rows, false);
  }

  private static String text(List<ReadingRow> rows, boolean withRange) {
    StringWriter text = new StringWriter();
    try (CsvWriter csv = CsvWriter.builder().lineDelimiter(LineDelimiter.LF).build(text)) {
      List<String> head = new ArrayList<>(List.of(ReadingsFile.POSE_COLUMNS));
      if (withRange) {
        head.add(ReadingsFile.RANGE);
      }
      csv.writeRecord(head);
      rows.forEach(row -> csv.writeRecord(fields(row, withRange)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text.toString();
  }

  private static List<String> fields(ReadingRow row, boolean withRange) {
    List<String> fields =
        new ArrayList<>(
            List.of(
                row.run(),
                row.sensor(),
                fixed(row.timeS(), DECIMALS_S),
                fixed(row.pose().position().xM(), DECIMALS_M),
                fixed(row.pose().position().zM(), DECIMALS_M),
                fixed(Math.toDegrees(row.pose().heading().radians()), DECIMALS_DEG)));
    if (withRange) {
      fields.add(row.reading() instanceof Echo echo ? fixed(echo.rangeM(), DECIMALS_M) : "");
    }
    return fields;
  }

  private static String fixed(double value, int decimals) {
    return new BigDecimal(value).setScale(decimals, RoundingMode.HALF_EVEN).toPlainString();
  }
}
