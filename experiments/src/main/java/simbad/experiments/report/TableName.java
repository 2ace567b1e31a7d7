package simbad.experiments.report;

import java.util.Locale;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableDocument;

/** How a table is named to people: with where its numbers come from, said once. */
public final class TableName {
  private TableName() {}

  /**
   * Returns an obstacle's name with its table's provenance, such as {@code angle (measured)}; the
   * name alone where it ends with that word.
   *
   * @param type obstacle with its table
   */
  public static String of(ObstacleType type) {
    return of(type.name(), type.thresholds());
  }

  /** Returns a name with a table's provenance, in the same way. */
  public static String of(String name, TableDocument table) {
    String word = table.provenanceWord();
    boolean isSaid = name.toLowerCase(Locale.ROOT).matches("(.*[^a-z])?" + word);
    return isSaid ? name : name + " (" + word + ")";
  }
}
