package simbad.blindworld.world;

import java.util.List;
import simbad.blindworld.check.Checks;

/**
 * An obstacle as a scene describes it.
 *
 * @param name its label
 * @param place where its own origin stands
 * @param turnRad its turn, counter-clockwise
 * @param outline its cross-section, a closed polygon in its own frame
 * @param shadow its thresholds
 */
public record Obstacle(
    String name, Point place, double turnRad, List<Point> outline, Shadow shadow) {

  /** Copies the outline, which needs at least three points. */
  public Obstacle {
    Checks.finite("turn", turnRad);
    outline = List.copyOf(outline);
    if (outline.size() < 3) {
      throw new IllegalArgumentException("outline: " + outline.size() + " points, expected 3");
    }
  }

  /** The radius of the circle round its own origin that holds it, in metres. */
  public double radiusM() {
    return outline.stream().mapToDouble(p -> StrictMath.hypot(p.xM(), p.zM())).max().orElseThrow();
  }
}
