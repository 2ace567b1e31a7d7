package simbad.obstacles;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

/**
 * The cross-sections of the three extrusions of Kranz (2014), section 3.3: one inch each, the axis
 * of rotation at the origin.
 */
public final class CrossSections {
  /** Half of an inch, in metres. */
  public static final double HALF_INCH_M = 0.0127;

  /** A sixteenth of an inch, the angle's thickness, in metres. */
  public static final double SIXTEENTH_INCH_M = 0.0015875;

  private static final int ROUND_CORNERS = 24;

  private CrossSections() {}

  /** Returns the one inch square tube, flat sides across the axes. */
  public static Outline square() {
    double h = HALF_INCH_M;
    return corners(h, h, h, -h, -h, -h, -h, h);
  }

  /**
   * Returns the one inch round tube as a polygon of 24 corners: 0.11 mm inside the circle at most.
   */
  public static Outline round() {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < ROUND_CORNERS; i++) {
      double angle = i * Angles.TURN_RAD / ROUND_CORNERS;
      corners.add(new Point(HALF_INCH_M * Math.cos(angle), HALF_INCH_M * Math.sin(angle)));
    }
    return Outline.of(corners);
  }

  /**
   * Returns the 1 x 1 x 1/16 inch angle. Its outer faces look to +x and -z, where two faces of the
   * square would be: so it was placed to match half of the square (section 4.1.4).
   */
  public static Outline angle() {
    double h = HALF_INCH_M;
    double in = h - SIXTEENTH_INCH_M;
    return corners(-h, -h, h, -h, h, h, in, h, in, -in, -h, -in);
  }

  private static Outline corners(double... xz) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < xz.length; i += 2) {
      corners.add(new Point(xz[i], xz[i + 1]));
    }
    return Outline.of(corners);
  }
}
