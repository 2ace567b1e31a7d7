package simbad.sonar.format;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.sonar.shape.Outline;

/**
 * A cross-section with what its file says about it.
 *
 * @param parts the bodies it is made of, at least one: most sections are one, a pair of legs is two
 * @param header the file's {@code # key: value} lines in their order
 */
public record OutlineDocument(List<Outline> parts, Map<String, String> header) {
  /** Copies both. */
  public OutlineDocument {
    parts = List.copyOf(parts);
    header = Collections.unmodifiableMap(new LinkedHashMap<>(header));
    if (parts.isEmpty()) {
      throw new IllegalArgumentException("parts is empty; a cross-section has at least one");
    }
  }

  /**
   * Returns a line of the header.
   *
   * @param key of the line
   */
  public Optional<String> header(String key) {
    return Optional.ofNullable(header.get(key));
  }

  /** Returns the greatest distance of a corner from the axis in metres. */
  public double reachM() {
    return parts.stream().mapToDouble(part -> part.reachM(0, 0)).max().orElseThrow();
  }
}
