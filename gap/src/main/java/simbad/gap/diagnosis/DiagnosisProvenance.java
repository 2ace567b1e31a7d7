package simbad.gap.diagnosis;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * What a diagnosis was made of and by.
 *
 * @param sha256 of every input file, by its name in the data set's folder, hexadecimal
 * @param version of the program
 * @param seed of what is resampled
 */
public record DiagnosisProvenance(Map<String, String> sha256, String version, long seed) {
  /** Copies the map in its order. */
  public DiagnosisProvenance {
    sha256 = Collections.unmodifiableMap(new LinkedHashMap<>(sha256));
  }
}
