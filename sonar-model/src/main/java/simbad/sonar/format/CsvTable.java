package simbad.sonar.format;

import de.siegmar.fastcsv.reader.CommentStrategy;
import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoublePredicate;
import java.util.regex.Pattern;

/** A csv file with a header row, read whole: comments apart, columns found by name. */
final class CsvTable {
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

  private final Path file;
  private final List<String> columns = new ArrayList<>();
  private final List<CsvRecord> rows = new ArrayList<>();
  private final List<String> comments = new ArrayList<>();
  private long headerLine = 1;

  private CsvTable(Path file) {
    this.file = file;
  }

  static CsvTable parse(Path file, String text) throws DataFormatException {
    CsvTable csv = new CsvTable(file);
    try (CsvReader<CsvRecord> reader =
        CsvReader.builder()
            .commentStrategy(CommentStrategy.READ)
            .allowMissingFields(true)
            .allowExtraFields(true)
            .ofCsvRecord(text)) {
      for (CsvRecord row : reader) {
        csv.take(row);
      }
    } catch (CsvParseException e) {
      throw DataFormatException.inFile(file, "is not a csv file: " + e.getMessage());
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
    if (csv.columns.isEmpty()) {
      throw DataFormatException.inFile(file, "is empty, expected a header row");
    }
    return csv;
  }

  private void take(CsvRecord row) throws DataFormatException {
    if (row.isComment()) {
      comments.add(row.getField(0));
    } else if (columns.isEmpty()) {
      takeHeader(row);
    } else if (row.getFieldCount() == columns.size()) {
      rows.add(row);
    } else {
      throw wrongFieldCount(row);
    }
  }

  private void takeHeader(CsvRecord row) throws DataFormatException {
    headerLine = row.getStartingLineNumber();
    for (String field : row.getFields()) {
      if (columns.contains(field.strip())) {
        throw DataFormatException.inField(file, headerLine, field.strip(), "column stands twice");
      }
      columns.add(field.strip());
    }
  }

  private DataFormatException wrongFieldCount(CsvRecord row) {
    String hint =
        row.getFieldCount() > columns.size() ? " (numbers take a decimal point, no comma)" : "";
    return DataFormatException.inField(
        file,
        row.getStartingLineNumber(),
        columns.get(Math.min(row.getFieldCount(), columns.size() - 1)),
        row.getFieldCount() + " fields in the row, expected " + columns.size() + hint);
  }

  Path file() {
    return file;
  }

  List<String> comments() {
    return comments;
  }

  int size() {
    return rows.size();
  }

  long line(int row) {
    return rows.get(row).getStartingLineNumber();
  }

  boolean hasColumn(String name) {
    return columns.contains(name);
  }

  void requireColumns(String... names) throws DataFormatException {
    for (String name : names) {
      if (!hasColumn(name)) {
        throw DataFormatException.inField(
            file, headerLine, name, "column is missing; found " + found());
      }
    }
  }

  private String found() {
    return String.join(", ", columns)
        + (columns.size() == 1 ? " (columns are separated by commas)" : "");
  }

  String text(int row, String column) {
    return rows.get(row).getField(columns.indexOf(column)).strip();
  }

  double number(int row, String column, DoublePredicate valid, String expected)
      throws DataFormatException {
    String text = text(row, column);
    double value = parse(text);
    if (!valid.test(value)) {
      throw fault(row, column, "'" + text + "' is not " + expected);
    }
    return value;
  }

  DataFormatException fault(int row, String column, String problem) {
    return DataFormatException.inField(file, line(row), column, problem);
  }

  /** What is no plain decimal number is NaN, and so fails every range. */
  private static double parse(String text) {
    return NUMBER.matcher(text).matches() ? Double.parseDouble(text) : Double.NaN;
  }
}
