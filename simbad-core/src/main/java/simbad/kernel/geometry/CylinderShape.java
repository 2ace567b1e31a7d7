package simbad.kernel.geometry;

import simbad.sonar.check.Checks;

/**
 * An upright round cylinder, its middle at the origin of its own frame.
 *
 * @param radiusM metres; finite, at least 0
 * @param heightM metres; finite, at least 0
 */
public record CylinderShape(double radiusM, double heightM) implements Shape {
  /** Checks the sizes. */
  public CylinderShape {
    Checks.notNegative("radiusM", radiusM);
    Checks.notNegative("heightM", heightM);
  }

  @Override
  public boolean strike(Ray ray) {
    boolean side = strikeSide(ray);
    boolean top = strikeDisc(ray, heightM / 2);
    boolean bottom = strikeDisc(ray, -heightM / 2);
    return side || top || bottom;
  }

  private boolean strikeSide(Ray ray) {
    double x = ray.originX();
    double z = ray.originZ();
    double level2 = ray.directionX() * ray.directionX() + ray.directionZ() * ray.directionZ();
    double along = -(x * ray.directionX() + z * ray.directionZ());
    double half2 = along * along - level2 * (x * x + z * z - radiusM * radiusM);
    if (level2 == 0 || !(half2 >= 0)) {
      return false;
    }
    double half = Math.sqrt(half2);
    boolean near = strikeSideAt(ray, (along - half) / level2);
    return strikeSideAt(ray, (along + half) / level2) || near;
  }

  private boolean strikeSideAt(Ray ray, double distanceM) {
    double y = ray.originY() + distanceM * ray.directionY();
    return Math.abs(y) <= heightM / 2 && ray.shortenTo(distanceM);
  }

  private boolean strikeDisc(Ray ray, double levelM) {
    if (ray.directionY() == 0) {
      return false;
    }
    double distanceM = (levelM - ray.originY()) * ray.inverseY();
    double x = ray.originX() + distanceM * ray.directionX();
    double z = ray.originZ() + distanceM * ray.directionZ();
    return x * x + z * z <= radiusM * radiusM && ray.shortenTo(distanceM);
  }

  @Override
  public void addTo(Extent extent, Placement worldFromShape) {
    extent.includeAround(
        worldFromShape,
        halfSpan(worldFromShape.rotation(0, 1)),
        halfSpan(worldFromShape.rotation(1, 1)),
        halfSpan(worldFromShape.rotation(2, 1)));
  }

  /** Half the span along an axis with which the cylinder's own axis has a given cosine. */
  private double halfSpan(double cos) {
    double sin = Math.sqrt(Math.max(0, 1 - cos * cos));
    return Math.abs(cos) * heightM / 2 + sin * radiusM;
  }
}
