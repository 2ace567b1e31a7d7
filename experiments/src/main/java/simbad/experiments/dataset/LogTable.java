package simbad.experiments.dataset;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OneLine;

/** Somebody's log as a table: rows from 0, columns from 0. Every fault names file, line, column. */
final class LogTable {
  private static final int SAMPLE = 1000;
  private static final int EXAMPLES = 3;
  private static final int MOST_SHOWN = 12;
  private static final int LONGEST_EXAMPLE = 20;

  private final Path file;
  private final List<String> names;
  private final long headerLine;
  private final List<LogLines.Line> rows;
  private final List<Integer> sections;
  private final boolean decimalComma;
  private final boolean unnamed;

  private LogTable(Builder made) {
    file = made.file;
    names = made.names;
    headerLine = made.headerLine;
    rows = made.rows;
    sections = made.sections;
    decimalComma = made.decimalComma;
    unnamed = made.unnamed;
  }

  /**
   * Reads a log.
   *
   * @param file plain or gzip
   * @param format what is known of it
   * @throws DataFormatException naming file, line and column of the first fault
   */
  static LogTable read(Path file, LogFormat format) throws DataFormatException {
    return parse(file, LogText.read(file, format.encoding()), format);
  }

  /** Reads a log whose text was read already. */
  static LogTable parse(Path file, String text, LogFormat format) throws DataFormatException {
    return new LogTable(new Builder(file, LogLines.of(file, text, format), format));
  }

  /** What the lines are. */
  private static final class Builder {
    private final Path file;
    private final List<String> names;
    private final long headerLine;
    private final List<LogLines.Line> rows = new ArrayList<>();
    private final List<Integer> sections = new ArrayList<>();
    private final boolean decimalComma;
    private final boolean unnamed;

    Builder(Path file, LogLines.Split split, LogFormat format) throws DataFormatException {
      this.file = file;
      List<LogLines.Line> lines = split.lines();
      decimalComma = format.decimalComma().orElse(hasCommas(lines, split.separator()));
      List<String> first = lines.get(0).fields();
      boolean header = format.header().orElse(first.stream().noneMatch(this::isNumber));
      headerLine = header ? lines.get(0).number() : 1;
      unnamed = !header;
      names = header ? first : numbered(lines);
      int section = 0;
      for (LogLines.Line line : header ? lines.subList(1, lines.size()) : lines) {
        if (header && line.fields().equals(first)) {
          section++;
        } else if (fits(line) || !format.skipBad()) {
          requireFit(line);
          rows.add(line);
          sections.add(section);
        }
      }
      if (rows.isEmpty()) {
        throw DataFormatException.inFile(file, "has no rows");
      }
    }

    private boolean isNumber(String cell) {
      return LogNumber.find(cell, decimalComma).isPresent();
    }

    /**
     * Numbers with a comma, and none with a point but between thousands. Where commas separate
     * fields too, three digits behind one are thousands.
     */
    private static boolean hasCommas(List<LogLines.Line> lines, char separator) {
      List<String> cells =
          lines.stream().limit(SAMPLE).flatMap(line -> line.fields().stream()).toList();
      return cells.stream().anyMatch(cell -> hasComma(cell, separator))
          && cells.stream()
              .filter(cell -> !LogNumber.isGrouped(cell, '.'))
              .noneMatch(cell -> cell.matches("[+-]?[\\d,]*\\.\\d+"));
    }

    private static boolean hasComma(String cell, char separator) {
      return cell.matches("[+-]?[\\d.]*,\\d+")
          && (separator != ',' || !LogNumber.isGrouped(cell, ','));
    }

    private static List<String> numbered(List<LogLines.Line> lines) {
      int widest =
          lines.stream().limit(SAMPLE).mapToInt(line -> line.fields().size()).max().orElse(0);
      return IntStream.rangeClosed(1, widest).mapToObj(number -> "column" + number).toList();
    }

    private boolean fits(LogLines.Line line) {
      return line.fields().stream().skip(names.size()).allMatch(String::isEmpty);
    }

    private void requireFit(LogLines.Line line) throws DataFormatException {
      if (!fits(line)) {
        throw DataFormatException.inField(
            file,
            line.number(),
            names.get(names.size() - 1),
            line.fields().size() + " fields in the row, expected " + names.size());
      }
    }
  }

  Path file() {
    return file;
  }

  int size() {
    return rows.size();
  }

  /** The names of the columns; of a log without a header column1, column2 and so on. */
  List<String> names() {
    return names;
  }

  /** Tells whether the log has no header. */
  boolean isUnnamed() {
    return unnamed;
  }

  boolean decimalComma() {
    return decimalComma;
  }

  /** How many headers have come again before a row: each begins another recording. */
  int section(int row) {
    return sections.get(row);
  }

  int sections() {
    return sections.get(sections.size() - 1) + 1;
  }

  long line(int row) {
    return rows.get(row).number();
  }

  /**
   * Finds a number of a column whose point may stand between thousands: it has three digits behind
   * it, and the column's other numbers have no point.
   */
  Optional<String> findThousands(int column) {
    List<String> cells =
        IntStream.range(0, Math.min(SAMPLE, size())).mapToObj(row -> text(row, column)).toList();
    boolean others =
        cells.stream().anyMatch(cell -> cell.matches("\\d{3}"))
            && cells.stream()
                .noneMatch(cell -> cell.indexOf('.') >= 0 && !LogNumber.isGrouped(cell, '.'));
    return others && !decimalComma
        ? cells.stream().filter(cell -> LogNumber.isGrouped(cell, '.')).findFirst()
        : Optional.empty();
  }

  /** Empty where the row ends before the column. */
  String text(int row, int column) {
    List<String> fields = rows.get(row).fields();
    return column < fields.size() ? fields.get(column) : "";
  }

  /** Tells whether a row ends before a column. */
  boolean isCut(int row, int column) {
    return column >= rows.get(row).fields().size();
  }

  /** A name for a data set's rows. */
  String label(int row, int column) throws DataFormatException {
    String name = text(row, column);
    if (!OneLine.isName(name)) {
      throw fault(row, column, "'" + name + "' is not " + OneLine.NAME);
    }
    return name;
  }

  Optional<LogNumber> findNumber(int row, int column) {
    return LogNumber.find(text(row, column), decimalComma);
  }

  DataFormatException fault(int row, int column, String problem) {
    return DataFormatException.inField(file, line(row), names.get(column), problem);
  }

  DataFormatException fault(String problem) {
    return DataFormatException.inFile(file, problem);
  }

  DataFormatException missing(String column) {
    return DataFormatException.inField(
        file, headerLine, column, "column is missing; found " + shown());
  }

  DataFormatException twice(String column) {
    return DataFormatException.inField(
        file, headerLine, column, "appears twice; give its number: " + shown());
  }

  /** The columns with their numbers and the first of what stands in them. */
  String shown() {
    String shown =
        IntStream.range(0, Math.min(MOST_SHOWN, names.size()))
            .mapToObj(
                column -> (column + 1) + " " + names.get(column) + " (" + examples(column) + ")")
            .collect(Collectors.joining(", "));
    return names.size() > MOST_SHOWN
        ? shown + " and " + (names.size() - MOST_SHOWN) + " more"
        : shown;
  }

  private String examples(int column) {
    return IntStream.range(0, Math.min(EXAMPLES, size()))
        .mapToObj(row -> OneLine.of(text(row, column), LONGEST_EXAMPLE))
        .collect(Collectors.joining(", "));
  }
}
