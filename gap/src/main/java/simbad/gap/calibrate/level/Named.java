package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.List;
import org.hipparchus.linear.RealMatrix;
import simbad.sonar.check.Checks;

/**
 * A value that was fitted, and how surely it is known.
 *
 * @param name with its unit
 * @param value in that unit
 * @param deviation standard, in the same
 */
public record Named(String name, double value, double deviation) {
  /** Refuses what is no number. */
  public Named {
    Checks.number("value", value);
    Checks.number("deviation", deviation);
  }

  /** Those of a fit that depend on no obstacle. */
  static List<Named> of(Layout layout, LevelFit fit, RealMatrix covariance) {
    double[] v = fit.values();
    List<Named> all = new ArrayList<>();
    all.add(plain("spreading_exponent", 0, v, covariance));
    all.add(plain("absorption_db_per_m", 1, v, covariance));
    all.add(plain("level_added_db", Layout.LEVEL, v, covariance));
    all.add(logarithmic("aperture_radius_m", layout.aperture(), v, covariance));
    double deg = Math.toDegrees(1);
    Named squint = plain("squint_deg", layout.squint(), v, covariance);
    all.add(new Named(squint.name, deg * squint.value, deg * squint.deviation));
    all.add(logarithmic("excess_sd_db", layout.scatter(), v, covariance));
    return List.copyOf(all);
  }

  private static Named plain(String name, int index, double[] v, RealMatrix covariance) {
    return new Named(name, v[index], Math.sqrt(covariance.getEntry(index, index)));
  }

  private static Named logarithmic(String name, int index, double[] v, RealMatrix covariance) {
    double value = Math.exp(v[index]);
    return new Named(name, value, value * Math.sqrt(covariance.getEntry(index, index)));
  }
}
