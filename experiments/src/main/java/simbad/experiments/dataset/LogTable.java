package simbad.experiments.dataset;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.NamedCsvRecord;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OneLine;
import simbad.sonar.format.TextFile;

/** Somebody's log as a csv file with a header. */
final class LogTable {
  /** In millimetres ten kilometres: what is more is a slip. */
  private static final double GREATEST = 1e7;

  private final Path file;
  private final List<NamedCsvRecord> rows;

  private LogTable(Path file, List<NamedCsvRecord> rows) {
    this.file = file;
    this.rows = rows;
  }

  static LogTable read(Path file, String... columns) throws DataFormatException {
    String text = TextFile.read(file);
    try (CsvReader<NamedCsvRecord> reader = CsvReader.builder().ofNamedCsvRecord(text)) {
      List<NamedCsvRecord> rows = reader.stream().toList();
      for (String column : columns) {
        if (!rows.isEmpty() && !rows.get(0).getHeader().contains(column)) {
          throw DataFormatException.inField(file, 1, column, "column is missing");
        }
      }
      if (rows.isEmpty()) {
        throw DataFormatException.inFile(file, "has no rows");
      }
      return new LogTable(file, rows);
    } catch (CsvParseException | IOException e) {
      throw DataFormatException.inFile(file, "is not a csv file: " + e.getMessage());
    }
  }

  int size() {
    return rows.size();
  }

  /** Empty where the row is shorter than the header. */
  String text(int row, String column) {
    return rows.get(row).findField(column).orElse("");
  }

  /**
   * A name for a data set's rows; empty where there is none.
   *
   * @throws DataFormatException if it is none that a data set may have
   */
  String label(int row, String column) throws DataFormatException {
    String name = text(row, column);
    if (!OneLine.isName(name)) {
      throw inField(row, column, "'" + name + "' is not " + OneLine.NAME);
    }
    return name;
  }

  /** A number of at least 0. */
  double number(int row, String column) throws DataFormatException {
    String text = text(row, column);
    try {
      double value = Double.parseDouble(text);
      if (value >= 0 && value <= GREATEST) {
        return value;
      }
    } catch (NumberFormatException e) {
      // Said below.
    }
    throw inField(row, column, "'" + text + "' is not a number of at least 0, at most " + GREATEST);
  }

  private DataFormatException inField(int row, String column, String problem) {
    return DataFormatException.inField(
        file, rows.get(row).getStartingLineNumber(), column, problem);
  }

  DataFormatException fault(String problem) {
    return DataFormatException.inFile(file, problem);
  }
}
