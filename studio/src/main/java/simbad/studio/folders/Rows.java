package simbad.studio.folders;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/** Rows of a csv file, one after the other: a trace may have a million. */
final class Rows {
  private final Path file;

  private Rows(Path file) {
    this.file = file;
  }

  /** What is done with a row. */
  @FunctionalInterface
  interface Each {
    void take(Row row) throws DataFormatException;
  }

  /**
   * Reads a file.
   *
   * @throws DataFormatException if it cannot be read, or is no csv file
   */
  static void read(Path file, Each each) throws DataFormatException {
    TextFile.requireFile(file);
    Rows rows = new Rows(file);
    try (CsvReader<NamedCsvRecord> reader =
        CsvReader.builder().allowMissingFields(true).ofNamedCsvRecord(file)) {
      for (NamedCsvRecord row : reader) {
        each.take(rows.new Row(row));
      }
    } catch (CsvParseException | UncheckedIOException | IOException e) {
      throw DataFormatException.inFile(file, "is not a csv file: " + e.getMessage());
    }
  }

  /** One row. */
  final class Row {
    private final NamedCsvRecord row;

    private Row(NamedCsvRecord row) {
      this.row = row;
    }

    NamedCsvRecord fields() {
      return row;
    }

    String text(String column) throws DataFormatException {
      return row.findField(column).orElseThrow(() -> fault(column, "is missing"));
    }

    double number(String column) throws DataFormatException {
      String text = text(column);
      try {
        double value = Double.parseDouble(text);
        if (Double.isFinite(value)) {
          return value;
        }
      } catch (NumberFormatException e) {
        // Said below.
      }
      throw fault(column, "'" + text + "' is not a number");
    }

    private DataFormatException fault(String column, String problem) {
      return DataFormatException.inField(file, row.getStartingLineNumber(), column, problem);
    }
  }
}
