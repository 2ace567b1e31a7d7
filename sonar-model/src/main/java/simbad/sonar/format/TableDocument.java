package simbad.sonar.format;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.shape.ThresholdBand;
import simbad.sonar.shape.ThresholdTable;

/**
 * A threshold table with what its file says about it.
 *
 * @param table the thresholds
 * @param header the file's {@code # key: value} lines in their order; keys are object, sensor,
 *     provenance, source, date, unit, resolution and any other
 * @param band how far the thresholds are uncertain, if the file tells; of the table's bearings
 */
public record TableDocument(
    ThresholdTable table, Map<String, String> header, Optional<ThresholdBand> band) {
  static final String PROVENANCE = "provenance";

  /**
   * Copies the header; what a file could not give back is refused: a key that is empty or holds a
   * colon, line breaks, space around, and a provenance that is none.
   */
  public TableDocument {
    header = Collections.unmodifiableMap(new LinkedHashMap<>(header));
    header.forEach(TableDocument::checkLine);
    if (band.isPresent() && band.get().size() != table.size()) {
      throw new IllegalArgumentException(
          "band has " + band.get().size() + " bearings, the table " + table.size());
    }
  }

  /** A table without a band. */
  public TableDocument(ThresholdTable table, Map<String, String> header) {
    this(table, header, Optional.empty());
  }

  private static void checkLine(String key, String value) {
    if (key.isEmpty() || key.indexOf(':') >= 0 || !fitsALine(key)) {
      throw new IllegalArgumentException(
          "header key '" + key + "' is not a word or words without colon on one line");
    }
    if (!fitsALine(value)) {
      throw new IllegalArgumentException(
          "header " + key + " = '" + value + "' is not a text on one line without space around");
    }
    if (key.equals(PROVENANCE) && Provenance.find(value).isEmpty()) {
      throw new IllegalArgumentException(
          "provenance = " + value + " is not one of " + Provenance.words());
    }
  }

  private static boolean fitsALine(String text) {
    return text.equals(text.strip()) && text.indexOf('\n') < 0 && text.indexOf('\r') < 0;
  }

  /** Returns the provenance, if the file states one. */
  public Optional<Provenance> provenance() {
    return header(PROVENANCE).flatMap(Provenance::find);
  }

  /** Returns the provenance as it is to be shown wherever the table is. */
  public String provenanceWord() {
    return provenance().map(Provenance::word).orElse("provenance not stated");
  }

  /**
   * Returns a line of the header.
   *
   * @param key of the line
   */
  public Optional<String> header(String key) {
    return Optional.ofNullable(header.get(key));
  }
}
