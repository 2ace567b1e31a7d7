package simbad.sonar.format;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.shape.ThresholdTable;

/**
 * A threshold table with what its file says about it.
 *
 * @param table the thresholds
 * @param header the file's {@code # key: value} lines in their order; keys are object, sensor,
 *     provenance, source, date, unit, resolution and any other
 */
public record TableDocument(ThresholdTable table, Map<String, String> header) {
  private static final String PROVENANCE = "provenance";

  /** Copies the header. */
  public TableDocument {
    header = Collections.unmodifiableMap(new LinkedHashMap<>(header));
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
