package simbad.sonar.model;

/**
 * What geometry says of one obstacle from one pose: as {@link Sight}, but reusable, so that many
 * pings can be computed without garbage.
 */
public final class SightLine {
  private double nearestM;
  private double centreDistanceM;
  private double bearingRad;
  private double thresholdM;

  /** Creates a line of sight to nothing. */
  public SightLine() {
    nearestM = Double.POSITIVE_INFINITY;
  }

  void set(double newNearestM, double newCentreDistanceM, double newBearingRad, double threshold) {
    nearestM = newNearestM;
    centreDistanceM = newCentreDistanceM;
    bearingRad = newBearingRad;
    thresholdM = threshold;
  }

  /** Returns the distance to the nearest point in the cone, metres; infinity when there is none. */
  public double nearestM() {
    return nearestM;
  }

  /** Returns the distance to the obstacle's centre, metres. */
  public double centreDistanceM() {
    return centreDistanceM;
  }

  /** Returns the sensor's bearing in the obstacle's own frame, radians in [0, 2 pi). */
  public double bearingRad() {
    return bearingRad;
  }

  /** Returns the threshold at that bearing, metres. */
  public double thresholdM() {
    return thresholdM;
  }
}
