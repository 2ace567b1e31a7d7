package simbad.blindworld.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A CSV file with a header line; fields may stand in double quotes. Blank lines are skipped. */
public final class Csv {

  private final String file;
  private final List<String> header;
  private final List<List<String>> rows;

  private Csv(String file, List<String> header, List<List<String>> rows) {
    this.file = file;
    this.header = header;
    this.rows = rows;
  }

  /** Reads a file. */
  public static Csv read(Path path) throws IOException, FormatException {
    return parse(path.toString(), Files.readString(path));
  }

  /** Reads a text; {@code file} names it in complaints. */
  public static Csv parse(String file, String text) throws FormatException {
    List<List<String>> lines = new ArrayList<>();
    int number = 0;
    int width = -1;
    for (String line : text.lines().toList()) {
      number++;
      if (!line.isBlank()) {
        List<String> fields = fields(line);
        width = width < 0 ? fields.size() : width;
        if (fields.size() != width) {
          throw new FormatException(
              "%s, line %d: %d fields, expected %d".formatted(file, number, fields.size(), width));
        }
        lines.add(fields);
      }
    }
    if (lines.isEmpty()) {
      throw new FormatException(file + ", line 1: nothing, expected a header");
    }
    return new Csv(file, lines.get(0), List.copyOf(lines.subList(1, lines.size())));
  }

  private static List<String> fields(String line) {
    List<String> fields = new ArrayList<>();
    StringBuilder field = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (c == '"') {
        boolean doubled = quoted && i + 1 < line.length() && line.charAt(i + 1) == '"';
        if (doubled) {
          field.append(c);
          i++;
        } else {
          quoted = !quoted;
        }
      } else if (c == ',' && !quoted) {
        fields.add(field.toString());
        field.setLength(0);
      } else {
        field.append(c);
      }
    }
    fields.add(field.toString());
    return fields;
  }

  /** How many rows follow the header. */
  public int size() {
    return rows.size();
  }

  /** The header's names. */
  public List<String> header() {
    return List.copyOf(header);
  }

  /** The index of a column. */
  public int column(String name) throws FormatException {
    int index = header.indexOf(name);
    if (index < 0) {
      throw new FormatException(file + ", line 1: no column '" + name + "'");
    }
    return index;
  }

  /** A field's text. */
  public String text(int row, int column) {
    return rows.get(row).get(column);
  }

  /** A field's number, which must be finite. */
  public double number(int row, int column) throws FormatException {
    String field = text(row, column).strip();
    try {
      double value = Double.parseDouble(field);
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // Said below, as for a number that is not finite.
    }
    throw new FormatException(
        "%s, line %d, %s: '%s', expected a number"
            .formatted(file, row + 2, header.get(column), field));
  }
}
