package simbad.kernel.geometry;

import simbad.sonar.check.Checks;

/**
 * A ball about the origin of its own frame.
 *
 * @param radiusM metres; finite, at least 0
 */
public record BallShape(double radiusM) implements Shape {
  /** Checks the radius. */
  public BallShape {
    Checks.notNegative("radiusM", radiusM);
  }

  @Override
  public boolean strike(Ray ray) {
    double x = ray.originX();
    double y = ray.originY();
    double z = ray.originZ();
    double along = -(x * ray.directionX() + y * ray.directionY() + z * ray.directionZ());
    double half2 = along * along - (x * x + y * y + z * z) + radiusM * radiusM;
    if (!(half2 >= 0)) {
      return false;
    }
    double half = Math.sqrt(half2);
    return ray.shortenTo(along >= half ? along - half : along + half);
  }

  @Override
  public void addTo(Extent extent, Placement worldFromShape) {
    extent.includeAround(worldFromShape, radiusM, radiusM, radiusM);
  }
}
