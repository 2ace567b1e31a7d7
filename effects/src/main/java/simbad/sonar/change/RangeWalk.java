package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.RangeChange;

/**
 * Weak echoes read longer than strong ones: a receiver with a fixed threshold is reached later on
 * the slope of a weak echo. What is added falls off with the echo's excess over the threshold.
 *
 * <p>How strong an echo is stands in the level law. Under the rule of thresholds it is taken to
 * fall with the fourth power of the distance, as of a small target (spreading there and back): 40
 * log10(threshold / distance) decibels over the threshold.
 *
 * @param atEdgeM what is added where the echo is just heard, metres; 0 is neutral
 * @param fallDb by how many decibels more excess it falls to a share of 1/e; positive
 */
public record RangeWalk(double atEdgeM, double fallDb) implements RangeChange {
  private static final double DB_PER_DECADE = 40;

  /** Checks the figures; NaN is refused. */
  public RangeWalk {
    Checks.finite("atEdgeM", atEdgeM);
    Checks.positive("fallDb", fallDb);
  }

  /** Of the nearest obstacle in the cone, which is the one that is read. */
  @Override
  public RangeChange at(Geometry geometry, int ping) {
    int nearest = -1;
    int end = (ping + 1) * geometry.obstacles();
    for (int line = ping * geometry.obstacles(); line < end; line++) {
      double distance = geometry.nearestM(line);
      if (distance < (nearest < 0 ? Double.POSITIVE_INFINITY : geometry.nearestM(nearest))) {
        nearest = line;
      }
    }
    return nearest < 0 ? this : new RangeOffset(addedM(excessDb(geometry, nearest)));
  }

  private static double excessDb(Geometry geometry, int line) {
    return geometry.ears() == null
        ? DB_PER_DECADE * Math.log10(geometry.thresholdM(line) / geometry.centreDistanceM(line))
        : geometry.excessDb(line);
  }

  /**
   * Returns what is added to a range.
   *
   * @param excessDb of the echo over the threshold; under 0 counts as 0, NaN as well
   */
  public double addedM(double excessDb) {
    return atEdgeM * Math.exp(-(excessDb > 0 ? excessDb : 0) / fallDb);
  }

  @Override
  public int order() {
    return 1;
  }
}
