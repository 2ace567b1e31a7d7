package simbad.sonar.ping;

import java.util.Arrays;
import simbad.sonar.scene.Obstacle;

/**
 * From where on an obstacle its echo comes, and how much stronger or weaker it is near by than its
 * strength says. A strength is that of a distance: near by, less of a flat side lies within one
 * wave of its nearest point, and its parts no longer add up.
 *
 * <p>Computed by Kirchhoff's integral round the outline ({@link OutlineEcho}). The dips of its
 * level are too deep: more than 3 dB is not believed.
 *
 * <p>Values are computed when they are first asked for. Two threads that compute one find the same.
 */
public final class NearField {
  /** Of references that were not fitted on, as much as this makes most likely. */
  private static final double MOST_DB = 3;

  /** Even bearings at which it is known, from 0 on. */
  private static final int BEARINGS = 144;

  private static final PolarGrid GRID = new PolarGrid(BEARINGS);

  private static final double LEAST_REFERENCE_M = 0.2;

  private final Obstacle obstacle;
  private final double[] offCentreRad = GRID.unknown();
  private final double[] addedDb = GRID.unknown();

  /** Of the echo from the distance at which the strength is believed, by bearing. */
  private final double[] believedDb = new double[BEARINGS];

  private final OutlineEcho outline;

  /**
   * Prepares the near field of an obstacle.
   *
   * @param obstacle its outline, and its thresholds: at their distance its strength is believed
   * @param wavenumberPerM of the carrier, radians per metre
   */
  public NearField(Obstacle obstacle, double wavenumberPerM) {
    this.obstacle = obstacle;
    outline = new OutlineEcho(obstacle.outline(), wavenumberPerM);
    Arrays.fill(believedDb, Double.NaN);
  }

  /**
   * Returns the level of the echo from the distance at which the strength is believed: that of the
   * obstacle's threshold. Of no common level: its differences between bearings are those of
   * strengths, but for dips that are too deep.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi]
   * @return decibels
   */
  public double believedDb(double bearingRad) {
    double lostM = obstacle.detection().thresholdM(bearingRad);
    double atM = Math.max(LEAST_REFERENCE_M, Math.min(GRID.furthestM(), lostM));
    return outline.echo(bearingRad, atM).levelDb();
  }

  /**
   * Returns the direction from which the echo comes.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi]
   * @param distanceM from the sensor to the obstacle's centre, positive
   * @return angle from the direction of the centre, radians, positive counter-clockwise
   */
  public double offCentreRad(double bearingRad, double distanceM) {
    return at(offCentreRad, bearingRad, distanceM);
  }

  /**
   * Returns by how much the echo is stronger than the strength at this bearing says, which is
   * believed of the threshold's distance.
   *
   * @param bearingRad of the sensor in the obstacle's own frame, in [0, 2 pi]
   * @param distanceM from the sensor to the obstacle's centre, positive
   * @return decibels, in [-3, 3]
   */
  public double addedDb(double bearingRad, double distanceM) {
    return at(addedDb, bearingRad, distanceM);
  }

  private double at(double[] values, double bearingRad, double distanceM) {
    return GRID.at((bearing, distance) -> value(values, bearing, distance), bearingRad, distanceM);
  }

  private double value(double[] values, int bearing, int distance) {
    int cell = GRID.cell(bearing, distance);
    double known = values[cell];
    if (Double.isNaN(known)) {
      double bearingRad = GRID.bearingRad(bearing);
      OutlineEcho.Echo echo = outline.echo(bearingRad, GRID.distanceM(distance));
      double added = echo.levelDb() - believedDb(bearing, bearingRad);
      offCentreRad[cell] = echo.offCentreRad();
      addedDb[cell] = Math.max(-MOST_DB, Math.min(MOST_DB, added));
      known = values[cell];
    }
    return known;
  }

  private double believedDb(int bearing, double bearingRad) {
    double known = believedDb[bearing];
    if (Double.isNaN(known)) {
      known = believedDb(bearingRad);
      believedDb[bearing] = known;
    }
    return known;
  }
}
