package simbad.sonar.format;

import de.siegmar.fastcsv.reader.CommentStrategy;
import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoublePredicate;
import java.util.regex.Pattern;

/**
 * A csv file with a header row, read whole: comments apart, columns found by name, rows counted
 * from 0. Every fault names the file, its line and the column.
 */
public final class CsvTable {
  private static final String DECIMAL_POINT = " (a number has a decimal point, not a comma)";
  private static final Pattern OTHER_SEPARATOR = Pattern.compile("[;\\t|]");

  /**
   * No digit can belong to two parts of it: with more than one way to read it, refusing takes time.
   */
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][+-]?\\d+)?");

  private final Path file;
  private final List<String> columns = new ArrayList<>();
  private final List<CsvRecord> rows = new ArrayList<>();
  private final List<Comment> comments = new ArrayList<>();
  private long headerLine = 1;

  /** What stands behind a #, and where. */
  record Comment(long line, String text) {}

  private CsvTable(Path file) {
    this.file = file;
  }

  /**
   * Reads a table from a text.
   *
   * @param file how messages name the text
   * @param text csv, lines that begin with # are comments
   * @throws DataFormatException if it is no csv, has no header, a column twice, or a row with too
   *     few or too many fields
   */
  public static CsvTable parse(Path file, String text) throws DataFormatException {
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
      throw DataFormatException.inFile(file, "is not a csv file: " + reason(e));
    } catch (IOException e) {
      throw DataFormatException.inFile(file, "cannot be read: " + e.getMessage());
    }
    if (csv.columns.isEmpty()) {
      throw DataFormatException.inFile(file, "is empty, expected a header row");
    }
    return csv;
  }

  /** The parser's message says where, that of its cause what. */
  private static String reason(CsvParseException e) {
    Throwable cause = e.getCause();
    return e.getMessage() + (cause == null ? "" : ": " + cause.getMessage());
  }

  private void take(CsvRecord row) throws DataFormatException {
    if (row.isComment()) {
      requireLine(row);
      comments.add(new Comment(row.getStartingLineNumber(), row.getField(0)));
    } else if (row.getFieldCount() == 1 && row.getField(0).isBlank()) {
      return;
    } else if (columns.isEmpty()) {
      takeHeader(row);
    } else if (row.getFieldCount() == columns.size()) {
      rows.add(row);
    } else {
      throw wrongFieldCount(row);
    }
  }

  private void requireLine(CsvRecord comment) throws DataFormatException {
    int length = comment.getField(0).length();
    if (length > OneLine.LONGEST_TEXT) {
      throw DataFormatException.inField(
          file,
          comment.getStartingLineNumber(),
          "#",
          length + " characters, expected at most " + OneLine.LONGEST_TEXT);
    }
  }

  private void takeHeader(CsvRecord row) throws DataFormatException {
    headerLine = row.getStartingLineNumber();
    if (row.getFieldCount() == 1 && OTHER_SEPARATOR.matcher(row.getField(0)).find()) {
      throw DataFormatException.inField(
          file,
          headerLine,
          row.getField(0),
          "found one column; columns are separated by commas" + DECIMAL_POINT);
    }
    for (String field : row.getFields()) {
      if (columns.contains(field.strip())) {
        throw DataFormatException.inField(file, headerLine, field.strip(), "column appears twice");
      }
      columns.add(field.strip());
    }
  }

  private DataFormatException wrongFieldCount(CsvRecord row) {
    int found = row.getFieldCount();
    String fields = found == 1 ? "1 field" : found + " fields";
    String hint = found > columns.size() ? DECIMAL_POINT : "";
    return DataFormatException.inField(
        file,
        row.getStartingLineNumber(),
        columns.get(Math.min(found, columns.size() - 1)),
        fields + " in the row, expected " + columns.size() + hint);
  }

  /** Returns the file's name as messages give it. */
  public Path file() {
    return file;
  }

  List<Comment> comments() {
    return comments;
  }

  /** Returns the number of rows, the header not counted. */
  public int size() {
    return rows.size();
  }

  /** Returns the line of the file that a row begins in, from 1. */
  public long line(int row) {
    return rows.get(row).getStartingLineNumber();
  }

  boolean hasColumn(String name) {
    return columns.contains(name);
  }

  /** Returns the {@code # key: value} lines in their order; of one key's lines the last. */
  public Map<String, String> header() {
    Map<String, String> header = new LinkedHashMap<>();
    for (Comment comment : comments) {
      int colon = Math.max(0, comment.text().indexOf(':'));
      String key = comment.text().substring(0, colon).strip();
      if (!key.isEmpty()) {
        header.put(key, comment.text().substring(colon + 1).strip());
      }
    }
    return header;
  }

  /** Returns the names of the columns in their order. */
  public List<String> columns() {
    return List.copyOf(columns);
  }

  /**
   * Checks that columns are there, in any order, beside others or not.
   *
   * @param names of the columns
   * @throws DataFormatException naming the first that is missing
   */
  public void requireColumns(String... names) throws DataFormatException {
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

  /**
   * Returns a field without the blanks round it.
   *
   * @param row from 0
   * @param column one that is there
   */
  public String text(int row, String column) {
    return rows.get(row).getField(columns.indexOf(column)).strip();
  }

  /**
   * Returns a field that is a name, without the blanks round it.
   *
   * @param row from 0
   * @param column one that is there
   * @throws DataFormatException if it has more than {@value OneLine#LONGEST_NAME} characters, or
   *     stands on more than one line
   */
  public String label(int row, String column) throws DataFormatException {
    String name = text(row, column);
    if (!OneLine.isName(name)) {
      throw fault(row, column, "'" + name + "' is not " + OneLine.NAME);
    }
    return name;
  }

  /**
   * Returns a field as a number.
   *
   * @param row from 0
   * @param column one that is there
   * @param valid false for NaN and for all that is out of range
   * @param expected what a valid field is, for the message
   * @throws DataFormatException if it is no plain decimal number or not valid
   */
  public double number(int row, String column, DoublePredicate valid, String expected)
      throws DataFormatException {
    String text = text(row, column);
    double value = parse(text);
    if (!valid.test(value)) {
      String hint = text.indexOf(',') >= 0 ? DECIMAL_POINT : "";
      throw fault(row, column, "'" + text + "' is not " + expected + hint);
    }
    return value;
  }

  /**
   * Makes the exception for a field that is wrong in another way.
   *
   * @param row from 0
   * @param column of the field
   * @param problem what is wrong and what was expected
   */
  public DataFormatException fault(int row, String column, String problem) {
    return fault(line(row), column, problem);
  }

  DataFormatException fault(long line, String field, String problem) {
    return DataFormatException.inField(file, line, field, problem);
  }

  /** What is no plain decimal number is NaN, and so fails every range. */
  private static double parse(String text) {
    return NUMBER.matcher(text).matches() ? Double.parseDouble(text) : Double.NaN;
  }
}
