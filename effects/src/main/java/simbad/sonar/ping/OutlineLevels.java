package simbad.sonar.ping;

import java.util.List;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

/**
 * How strongly an outline answers from all sides and distances, of no common level, so that two of
 * one wave may be compared: Kirchhoff's integral ({@link OutlineEcho}), and what one edge sends
 * back alone (a wave over 4 pi, as a length), since a real outline's echoes never cancel further.
 *
 * <p>Values are computed when they are first asked for. Two threads that compute one find the same.
 * Equal where outline and wave are.
 */
public final class OutlineLevels {
  /** A side of 10 cm has its first dip 2.5 degrees beside its normal. */
  private static final int BEARINGS = 288;

  private static final PolarGrid GRID = new PolarGrid(BEARINGS);

  private final Outline outline;
  private final double wavenumberPerM;
  private final OutlineEcho echo;
  private final boolean mirrored;
  private final double[] levelDb = GRID.unknown();

  /**
   * Prepares them.
   *
   * @param outline in its own frame, the origin in or near it
   * @param wavenumberPerM of the carrier, radians per metre, positive
   */
  public OutlineLevels(Outline outline, double wavenumberPerM) {
    this.outline = outline;
    this.wavenumberPerM = wavenumberPerM;
    echo = new OutlineEcho(outline, wavenumberPerM);
    mirrored = isMirrored(outline);
  }

  /** Whether each corner has its mirror images beyond both axes, so that a quarter says all. */
  private static boolean isMirrored(Outline outline) {
    List<Point> corners = outline.corners();
    return corners.stream()
        .allMatch(
            c ->
                corners.contains(new Point(-c.xM(), c.zM()))
                    && corners.contains(new Point(c.xM(), -c.zM())));
  }

  /** Returns the outline. */
  public Outline outline() {
    return outline;
  }

  /** Returns the radians per metre of the carrier. */
  public double wavenumberPerM() {
    return wavenumberPerM;
  }

  /**
   * Returns how strongly it answers: straight between its values, over the bearing and over the
   * distance.
   *
   * @param bearingRad of the sensor in the outline's own frame, in [0, 2 pi]
   * @param distanceM from the sensor to the frame's origin, positive
   * @return decibels, of a piece of one metre that faces the sensor
   */
  public double levelDb(double bearingRad, double distanceM) {
    return GRID.at(this::value, bearingRad, distanceM);
  }

  /** The bearing that has the same level, and is the first to. */
  private int like(int bearing) {
    int half = bearing % (BEARINGS / 2);
    return mirrored ? Math.min(half, BEARINGS / 2 - half) : bearing;
  }

  private double value(int asked, int distance) {
    int bearing = like(asked);
    int cell = GRID.cell(bearing, distance);
    double known = levelDb[cell];
    if (Double.isNaN(known)) {
      double edgeM = 1 / (2 * wavenumberPerM);
      double power =
          Math.pow(10, echo.levelDb(GRID.bearingRad(bearing), GRID.distanceM(distance)) / 10);
      known = 10 * Math.log10(power + edgeM * edgeM);
      levelDb[cell] = known;
    }
    return known;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof OutlineLevels that
        && wavenumberPerM == that.wavenumberPerM
        && outline.equals(that.outline);
  }

  @Override
  public int hashCode() {
    return 31 * outline.hashCode() + Double.hashCode(wavenumberPerM);
  }

  @Override
  public String toString() {
    return "levels of an outline of " + outline.size() + " corners";
  }
}
