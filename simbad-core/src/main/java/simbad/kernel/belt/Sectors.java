package simbad.kernel.belt;

import simbad.sonar.sensing.Readings;

/** Means and counts over the rays of a belt that look into a sector. Immutable. */
public final class Sectors {
  private final BeltLayout layout;

  /** Creates the sectors of a belt. */
  public Sectors(BeltLayout layout) {
    this.layout = layout;
  }

  /**
   * Counts the echoes of a sector.
   *
   * @param readings of the belt
   * @param fromRad least angle, included
   * @param toRad greatest angle, included
   */
  public int echoes(Readings readings, double fromRad, double toRad) {
    int count = 0;
    for (int i = 0; i < layout.size(); i++) {
      if (isHeard(readings, i, fromRad, toRad)) {
        count++;
      }
    }
    return count;
  }

  /**
   * Returns the mean range over the echoes of a sector.
   *
   * @param readings of the belt
   * @param fromRad least angle, included
   * @param toRad greatest angle, included
   * @param otherwise the answer if there is no echo
   */
  public double meanRangeM(Readings readings, double fromRad, double toRad, double otherwise) {
    double sum = 0;
    int count = 0;
    for (int i = 0; i < layout.size(); i++) {
      if (isHeard(readings, i, fromRad, toRad)) {
        sum += readings.rangeM(i);
        count++;
      }
    }
    return count == 0 ? otherwise : sum / count;
  }

  private boolean isHeard(Readings readings, int ray, double fromRad, double toRad) {
    double angle = layout.angleRad(ray);
    return angle >= fromRad && angle <= toRad && readings.isEcho(ray);
  }
}
