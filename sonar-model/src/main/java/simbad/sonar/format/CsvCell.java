package simbad.sonar.format;

/** Text in a cell of a CSV file. */
public final class CsvCell {
  private CsvCell() {}

  /**
   * Returns a text as it stands in a cell: in quotes where it has a comma, a quote or a new line
   * (RFC 4180).
   */
  public static String of(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? text : "\"" + text.replace("\"", "\"\"") + "\"";
  }
}
