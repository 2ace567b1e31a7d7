package simbad.experiments.dataset;

import de.siegmar.fastcsv.reader.CsvParseException;
import de.siegmar.fastcsv.reader.CsvReader;
import de.siegmar.fastcsv.reader.CsvRecord;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import simbad.sonar.format.DataFormatException;

/** The fields of a log's lines, whatever separates them; comments and empty lines left out. */
final class LogLines {
  private static final int MOST = 2_000_000;
  private static final int SAMPLE = 200;
  private static final Pattern BLANKS = Pattern.compile("[ \\t\\u00a0]+");
  private static final Pattern LINE_END = Pattern.compile("\\r\\n|\\r|\\n");

  /** In the order of preference where two do equally well: a comma may stand in numbers. */
  private static final char[] SEPARATORS = {';', '\t', '|', ',', ' '};

  /** What Excel writes and reads before a table. */
  private static final Pattern SEPARATOR_LINE = Pattern.compile("(?i)\"?sep=(.)\"?\\s*");

  private static final Pattern DATE = Pattern.compile("[\\d:T.,/Z -]*\\d[:/-]\\d[\\d:T.,/Z+ -]*");

  private LogLines() {}

  /**
   * One line's fields.
   *
   * @param number of the line in the file, from 1
   * @param fields without the blanks round them
   */
  record Line(long number, List<String> fields) {}

  /**
   * The lines with what separates their fields.
   *
   * @param separator a blank for any number of blanks and tabs
   * @param lines at least one
   */
  record Split(char separator, List<Line> lines) {}

  /**
   * Splits a text.
   *
   * @param file how messages name it
   * @param text all of it
   * @param format what is known of it
   * @throws DataFormatException if it holds nothing, or no quote ends
   */
  static Split of(Path file, String text, LogFormat format) throws DataFormatException {
    String[] plain = LINE_END.split(text);
    for (int i = 0; i < plain.length; i++) {
      plain[i] = i < format.skip() || isComment(plain[i].strip(), format) ? "" : plain[i];
    }
    Optional<Character> told = format.separator();
    Matcher first = SEPARATOR_LINE.matcher(plain[0]);
    if (first.matches()) {
      plain[0] = "";
      told = told.or(() -> Optional.of(first.group(1).charAt(0)));
    }
    boolean isFree = told.isEmpty() && format.header().isEmpty();
    Optional<SerialLines.Table> serial = isFree ? SerialLines.of(plain) : Optional.empty();
    Split split = serial.isPresent() ? serial(file, serial.get()) : split(file, plain, told);
    if (split.lines().isEmpty()) {
      throw DataFormatException.inFile(file, "holds no line of a table");
    }
    return split;
  }

  private static Split split(Path file, String[] plain, Optional<Character> told)
      throws DataFormatException {
    List<String> sample =
        Arrays.stream(plain).filter(line -> !line.isBlank()).limit(SAMPLE).toList();
    if (sample.isEmpty()) {
      return new Split(',', List.of());
    }
    char separator = told.orElseGet(() -> best(sample));
    return new Split(separator, parsed(file, plain, separator));
  }

  /** With the times before the arrows as the first column, and the labels as names. */
  private static Split serial(Path file, SerialLines.Table table) throws DataFormatException {
    boolean isNamed = !table.names().isEmpty();
    Split split =
        split(
            file,
            table.lines().toArray(String[]::new),
            isNamed ? Optional.of('\t') : Optional.empty());
    List<Line> lines = new ArrayList<>();
    for (Line line : split.lines()) {
      boolean words = line.fields().stream().noneMatch(cell -> isValue(cell, split.separator()));
      if (lines.isEmpty() && isNamed) {
        lines.add(stamped(table, line.number(), SerialLines.TIME, table.names()));
      }
      String time = table.stamps().isEmpty() ? "" : table.stamps().get((int) line.number() - 1);
      String first = lines.isEmpty() && words ? SerialLines.TIME : time;
      lines.add(stamped(table, line.number(), first, line.fields()));
    }
    return new Split(split.separator(), lines);
  }

  private static Line stamped(
      SerialLines.Table table, long number, String first, List<String> fields) {
    if (table.stamps().isEmpty()) {
      return new Line(number, fields);
    }
    List<String> all = new ArrayList<>(List.of(first));
    all.addAll(fields);
    return new Line(number, all);
  }

  private static boolean isComment(String line, LogFormat format) {
    return line.startsWith("#")
        || line.startsWith("%")
        || line.startsWith("//")
        || format.comment().filter(line::startsWith).isPresent();
  }

  private static List<Line> parsed(Path file, String[] plain, char separator)
      throws DataFormatException {
    boolean blanks = separator == ' ';
    String text =
        Arrays.stream(plain)
            .map(line -> blanks ? tabbed(line) : line)
            .collect(Collectors.joining("\n"));
    List<Line> lines = new ArrayList<>();
    try (CsvReader<CsvRecord> reader =
        CsvReader.builder()
            .fieldSeparator(blanks ? '\t' : separator)
            .allowMissingFields(true)
            .allowExtraFields(true)
            .ofCsvRecord(text)) {
      for (CsvRecord row : reader) {
        List<String> fields = row.getFields().stream().map(String::strip).toList();
        if (!fields.stream().allMatch(String::isEmpty)) {
          lines.add(new Line(row.getStartingLineNumber(), fields));
        }
        if (lines.size() > MOST) {
          throw DataFormatException.inFile(file, "has more than " + MOST + " lines");
        }
      }
    } catch (CsvParseException | IOException e) {
      Throwable cause = e.getCause();
      String reason = cause == null ? "" : ": " + cause.getMessage();
      throw DataFormatException.inFile(file, "is not a table: " + e.getMessage() + reason);
    }
    return lines;
  }

  private static String tabbed(String line) {
    return BLANKS.matcher(line.strip()).replaceAll("\t");
  }

  /** The one that cuts most lines alike, into what looks like numbers. */
  private static char best(List<String> sample) {
    char best = ',';
    double most = 0;
    for (char separator : SEPARATORS) {
      double merit = merit(sample, separator);
      if (merit > most) {
        most = merit;
        best = separator;
      }
    }
    return best;
  }

  private static double merit(List<String> sample, char separator) {
    List<String[]> lines = sample.stream().map(line -> fields(line, separator)).toList();
    int usual =
        lines.stream()
            .collect(Collectors.groupingBy(fields -> fields.length, Collectors.counting()))
            .entrySet()
            .stream()
            .max((a, b) -> Long.compare(a.getValue(), b.getValue()))
            .orElseThrow()
            .getKey();
    List<String[]> alike = lines.stream().filter(fields -> fields.length == usual).toList();
    if (usual < 2) {
      return 0;
    }
    long cells = (long) usual * alike.size();
    long numbers =
        alike.stream().flatMap(Arrays::stream).filter(cell -> isValue(cell, separator)).count();
    // A header line's names are no values, and a column of words may be one of two.
    return (double) alike.size() / lines.size() * (numbers + 1) / (cells + 1);
  }

  private static String[] fields(String line, char separator) {
    return separator == ' '
        ? BLANKS.split(line.strip())
        : line.split(Pattern.quote(String.valueOf(separator)), -1);
  }

  private static boolean isValue(String cell, char separator) {
    String plain = cell.strip().replaceAll("^\"|\"$", "");
    return plain.isEmpty()
        || LogNumber.find(plain, separator != ',').isPresent()
        || (plain.length() < 40 && DATE.matcher(plain).matches());
  }
}
