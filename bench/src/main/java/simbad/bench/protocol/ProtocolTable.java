package simbad.bench.protocol;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.ShippedText;

/** The table docs/protocol.csv, from which the firmware is made as well. Immutable. */
public final class ProtocolTable {
  private static final String FILE = "protocol.csv";

  private final List<Entry> entries;

  /** What kind of thing a row names. */
  public enum Kind {
    /** A byte that the firmware obeys. */
    COMMAND,
    /** What became of a ping. */
    STATUS,
    /** The answer to a command, by number. */
    ANSWER,
    /** The cause of a reset. */
    RESET
  }

  /**
   * A row.
   *
   * @param kind what it names
   * @param code what goes over the line
   * @param word its name
   * @param meaning for people
   */
  public record Entry(Kind kind, String code, String word, String meaning) {}

  private ProtocolTable(List<Entry> entries) {
    this.entries = List.copyOf(entries);
  }

  /** Returns the table that belongs to this version. */
  public static ProtocolTable shipped() {
    try {
      return parse(Path.of(FILE), ShippedText.read(ProtocolTable.class, FILE));
    } catch (DataFormatException e) {
      throw new IllegalStateException(e);
    }
  }

  /**
   * Reads a table.
   *
   * @param name how messages name the text
   * @param text csv with the columns kind, code, word, meaning
   * @throws DataFormatException naming line and field of the first fault
   */
  public static ProtocolTable parse(Path name, String text) throws DataFormatException {
    CsvTable csv = CsvTable.parse(name, text);
    csv.requireColumns("kind", "code", "word", "meaning");
    List<Entry> entries = new ArrayList<>();
    for (int row = 0; row < csv.size(); row++) {
      entries.add(
          new Entry(
              kind(csv, row), csv.text(row, "code"), csv.text(row, "word"), meaning(csv, row)));
    }
    return new ProtocolTable(entries);
  }

  private static String meaning(CsvTable csv, int row) {
    return csv.text(row, "meaning");
  }

  private static Kind kind(CsvTable csv, int row) throws DataFormatException {
    return switch (csv.text(row, "kind")) {
      case "command" -> Kind.COMMAND;
      case "status" -> Kind.STATUS;
      case "answer" -> Kind.ANSWER;
      case "reset" -> Kind.RESET;
      default -> throw csv.fault(row, "kind", "is none of command, status, answer, reset");
    };
  }

  /** Returns all rows in their order. */
  public List<Entry> entries() {
    return entries;
  }

  /**
   * Finds a row by what goes over the line.
   *
   * @param kind of the row
   * @param code such as {@code 17} or {@code p}
   */
  public Optional<Entry> find(Kind kind, String code) {
    return entries.stream()
        .filter(entry -> entry.kind() == kind && entry.code().equals(code))
        .findFirst();
  }

  /**
   * Returns the byte of a command.
   *
   * @param word such as {@code identify}
   * @throws IllegalArgumentException if there is no such command
   */
  public byte command(String word) {
    return entries.stream()
        .filter(entry -> entry.kind() == Kind.COMMAND && entry.word().equals(word))
        .map(entry -> (byte) entry.code().charAt(0))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("word = " + word + " is not a command"));
  }
}
