package simbad.blindworld.score;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/**
 * So many out of so many, with Wilson's 95 % interval (Wilson 1927, JASA 22, 209).
 *
 * @param hits at least 0
 * @param of at least {@code hits}; with 0 the interval is all of [0, 1]
 */
public record Proportion(int hits, int of) {

  private static final double Z = 1.959964;

  /** Refuses more hits than trials. */
  public Proportion {
    if (hits < 0 || hits > of) {
      throw new IllegalArgumentException("hits: " + hits + ", expected 0 to " + of);
    }
  }

  /** The share itself; 0 of nothing. */
  public double share() {
    return of == 0 ? 0 : (double) hits / of;
  }

  /** The lower end of the interval. */
  public double low() {
    return of == 0 ? 0 : Math.max(0, centre() - half());
  }

  /** The upper end of the interval. */
  public double high() {
    return of == 0 ? 1 : Math.min(1, centre() + half());
  }

  private double centre() {
    return (share() + Z * Z / (2 * of)) / (1 + Z * Z / of);
  }

  private double half() {
    double p = share();
    return Z * Math.sqrt(p * (1 - p) / of + Z * Z / (4.0 * of * of)) / (1 + Z * Z / of);
  }

  Map<String, Object> json() {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("hits", hits);
    json.put("of", of);
    json.put("share", share());
    json.put("low95", low());
    json.put("high95", high());
    return json;
  }

  @Override
  public String toString() {
    return of == 0
        ? "-"
        : String.format(
            Locale.ROOT,
            "%d/%d %.0f%% [%.0f-%.0f]",
            hits,
            of,
            100 * share(),
            100 * low(),
            100 * high());
  }
}
