package simbad.obstacles;

import java.util.List;
import simbad.sonar.format.TableDocument;
import simbad.sonar.shape.Outline;

/**
 * A kind of obstacle: its cross-section and the distances at which a sonar loses it.
 *
 * @param name short, as on the command line
 * @param parts the bodies of the cross-section in its own frame, metres; at least one
 * @param thresholds table in the same frame, with its provenance
 */
public record ObstacleType(String name, List<Outline> parts, TableDocument thresholds) {
  /** Copies the list. */
  public ObstacleType {
    parts = List.copyOf(parts);
    if (parts.isEmpty()) {
      throw new IllegalArgumentException("parts is empty; an obstacle has at least one body");
    }
  }

  /**
   * Creates a type of one body.
   *
   * @param name short, as on the command line
   * @param outline its cross-section
   * @param thresholds table in the same frame
   */
  public ObstacleType(String name, Outline outline, TableDocument thresholds) {
    this(name, List.of(outline), thresholds);
  }

  /**
   * Returns what a sonar model takes for the surface: the cross-section, the bodies of one of
   * several joined by a straight line of no width between their first corners.
   */
  public Outline outline() {
    return Outline.joined(parts);
  }
}
