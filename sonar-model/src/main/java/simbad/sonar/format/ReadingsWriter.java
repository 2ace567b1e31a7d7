package simbad.sonar.format;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.Closeable;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.math.BigDecimal;
import java.math.RoundingMode;
import java.nio.channels.Channels;
import java.nio.channels.WritableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * Writes what {@link ReadingsFile} reads, rounded to what a bench can tell: milliseconds, tenths of
 * a millimetre, thousandths of a degree. Row by row, or all rows as a text. Not thread-safe.
 */
public final class ReadingsWriter implements Closeable {
  private static final int DECIMALS_S = 3;
  private static final int DECIMALS_M = 4;
  private static final int DECIMALS_DEG = 3;

  private final CsvWriter csv;
  private final boolean withRange;

  private ReadingsWriter(CsvWriter csv, boolean withRange) {
    this.csv = csv;
    this.withRange = withRange;
  }

  private static ReadingsWriter begin(Writer target, boolean withRange) {
    CsvWriter csv = CsvWriter.builder().lineDelimiter(LineDelimiter.LF).build(target);
    List<String> head = new ArrayList<>(List.of(ReadingsFile.POSE_COLUMNS));
    if (withRange) {
      head.add(ReadingsFile.RANGE);
    }
    csv.writeRecord(head);
    return new ReadingsWriter(csv, withRange);
  }

  /**
   * Begins rows with their readings.
   *
   * @param channel the file; closed with the writer
   */
  public static ReadingsWriter to(WritableByteChannel channel) {
    return begin(Channels.newWriter(channel, StandardCharsets.UTF_8), true);
  }

  /**
   * Writes the next row.
   *
   * @throws UncheckedIOException if it cannot be written
   */
  public void write(ReadingRow row) {
    csv.writeRecord(fields(row));
  }

  @Override
  public void close() throws IOException {
    csv.close();
  }

  /**
   * Returns rows with their readings as the text of a file.
   *
   * @param rows in the order of the text
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
    try (ReadingsWriter writer = begin(text, withRange)) {
      rows.forEach(writer::write);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text.toString();
  }

  private List<String> fields(ReadingRow row) {
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
