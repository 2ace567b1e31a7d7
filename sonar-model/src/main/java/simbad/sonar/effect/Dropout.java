package simbad.sonar.effect;

/**
 * Pings are missed singly, whatever the geometry.
 *
 * @param share of the pings, in [0, 1]; 0 is neutral
 */
public record Dropout(double share) implements LossChange {
  @Override
  public double share(Geometry geometry, int ping) {
    return share;
  }
}
