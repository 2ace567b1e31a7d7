package simbad.sonar.format;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.Closeable;
import java.io.IOException;
import java.io.StringWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.channels.Channels;
import java.nio.channels.WritableByteChannel;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * Writes what {@link ReadingsFile} reads, rounded to what a bench can tell: milliseconds, tenths of
 * a millimetre, thousandths of a degree. Row by row, or all rows as a text. Not thread-safe.
 */
public final class ReadingsWriter implements Closeable {
  static final int DECIMALS_S = 3;
  static final int DECIMALS_M = 4;
  static final int DECIMALS_DEG = 3;

  /** Where logs come from elsewhere, two rows may be less than a millisecond apart. */
  private static final int MOST_DECIMALS_S = 6;

  private final CsvWriter csv;
  private final boolean withRange;
  private final boolean withTime;
  private final int decimalsS;
  private final List<CircumstanceColumns.Column> more;

  private ReadingsWriter(Writer target, boolean withRange, List<ReadingRow> rows, boolean isFine) {
    csv = CsvWriter.builder().lineDelimiter(LineDelimiter.LF).build(target);
    this.withRange = withRange;
    withTime = rows.stream().allMatch(ReadingRow::isTimed);
    boolean rounded = !isFine || rows.stream().allMatch(ReadingsWriter::isOnTheMs);
    decimalsS = rounded ? DECIMALS_S : MOST_DECIMALS_S;
    more = CircumstanceColumns.of(rows);
  }

  private static boolean isOnTheMs(ReadingRow row) {
    // What is left over by rounding a number of seconds, or a date's.
    double ms = row.timeS() * 1e3;
    return Math.abs(ms - Math.rint(ms)) < 1e-3;
  }

  private void head(Collection<String> further) {
    List<String> head = new ArrayList<>(List.of(ReadingsFile.POSE_COLUMNS));
    if (!withTime) {
      head.remove(ReadingsFile.TIME);
    }
    if (withRange) {
      head.add(ReadingsFile.RANGE);
    }
    more.forEach(column -> head.add(column.name()));
    head.addAll(further);
    csv.writeRecord(head);
  }

  /**
   * Begins rows of the first format with their readings.
   *
   * @param channel the file; closed with the writer
   */
  public static ReadingsWriter to(WritableByteChannel channel) {
    Writer target = Channels.newWriter(channel, StandardCharsets.UTF_8);
    ReadingsWriter writer = new ReadingsWriter(target, true, List.of(), false);
    writer.head(List.of());
    return writer;
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
   * @param rows in the order of the text; what they say beside the first format's columns stands in
   *     those of the second
   */
  public static String text(List<ReadingRow> rows) {
    return text(rows, true, Map.of(), false);
  }

  /**
   * Returns rows with their readings, of times as many decimals as they have, and with columns that
   * nothing reads.
   *
   * @param rows in the order of the text
   * @param further cells of each further column, one for each row
   */
  public static String text(List<ReadingRow> rows, Map<String, List<String>> further) {
    return text(rows, true, further, true);
  }

  /**
   * Returns the poses of rows as the text of a file without a column for the range.
   *
   * @param rows in the order of the text
   */
  public static String posesText(List<ReadingRow> rows) {
    return text(rows, false, Map.of(), false);
  }

  private static String text(
      List<ReadingRow> rows, boolean withRange, Map<String, List<String>> further, boolean isFine) {
    StringWriter text = new StringWriter();
    try (ReadingsWriter writer = new ReadingsWriter(text, withRange, rows, isFine)) {
      writer.head(further.keySet());
      for (int i = 0; i < rows.size(); i++) {
        List<String> fields = writer.fields(rows.get(i));
        for (List<String> column : further.values()) {
          fields.add(column.get(i));
        }
        writer.csv.writeRecord(fields);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return text.toString();
  }

  private List<String> fields(ReadingRow row) {
    List<String> fields = new ArrayList<>(List.of(row.run(), row.sensor()));
    if (withTime) {
      fields.add(fixed(row.timeS(), decimalsS));
    }
    fields.add(fixed(row.pose().position().xM(), DECIMALS_M));
    fields.add(fixed(row.pose().position().zM(), DECIMALS_M));
    fields.add(fixed(Math.toDegrees(row.pose().heading().radians()), DECIMALS_DEG));
    if (withRange) {
      fields.add(row.reading() instanceof Echo echo ? fixed(echo.rangeM(), DECIMALS_M) : "");
    }
    more.forEach(column -> fields.add(column.text().apply(row)));
    return fields;
  }

  static String fixed(double value, int decimals) {
    return FixedDecimals.of(value, decimals);
  }
}
