package simbad.sonar.effect;

import simbad.sonar.check.Checks;

/**
 * Pings are missed singly, whatever the geometry.
 *
 * @param share of the pings, in [0, 1]; 0 is neutral
 */
public record Dropout(double share) implements LossChange {
  /** Checks the figure; NaN is refused. */
  public Dropout {
    Checks.share("share", share);
  }

  @Override
  public double share(Geometry geometry, int ping) {
    return share;
  }
}
