package simbad.blindworld.world;

import java.util.List;

/**
 * The thresholds of an obstacle by bearing: the radius of the polygon whose corners are the given
 * radii at even bearings, or one radius all round.
 *
 * @param radiiM radii at bearings 0, 360/n, ...; one radius means the same all round
 */
public record Shadow(List<Double> radiiM) {

  /** Copies the list; it needs one radius or at least three, none negative. */
  public Shadow {
    radiiM = List.copyOf(radiiM);
    if (radiiM.size() != 1 && radiiM.size() < 3) {
      throw new IllegalArgumentException("radii: " + radiiM.size() + ", expected 1 or at least 3");
    }
    for (double radius : radiiM) {
      if (!(radius >= 0)) {
        throw new IllegalArgumentException("radius: " + radius + ", expected at least 0");
      }
    }
  }

  /** The same threshold at every bearing. */
  public static Shadow uniform(double radiusM) {
    return new Shadow(List.of(radiusM));
  }

  /** True when the threshold is one and the same all round by declaration. */
  public boolean isUniform() {
    return radiiM.size() == 1;
  }

  /** The greatest threshold, in metres. */
  public double greatestM() {
    return radiiM.stream().mapToDouble(Double::doubleValue).max().orElseThrow();
  }

  /**
   * The threshold at a bearing in the obstacle's own frame, in metres.
   *
   * <p>The chord between (a, 0) and (b, w) in polar coordinates has the radius a b sin w / (a sin t
   * + b sin(w - t)) at the angle t, by the areas of the triangles that it cuts off.
   */
  public double atM(double bearingRad) {
    if (isUniform()) {
      return radiiM.get(0);
    }
    int n = radiiM.size();
    double turns = bearingRad / (2 * Math.PI);
    double place = (turns - Math.floor(turns)) * n;
    int k = (int) place % n;
    double wedge = 2 * Math.PI / n;
    double within = (place - Math.floor(place)) * wedge;
    double before = radiiM.get(k);
    double after = radiiM.get((k + 1) % n);
    double area = before * StrictMath.sin(within) + after * StrictMath.sin(wedge - within);
    return area > 0 ? before * after * StrictMath.sin(wedge) / area : Math.min(before, after);
  }
}
