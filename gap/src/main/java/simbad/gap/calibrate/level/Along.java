package simbad.gap.calibrate.level;

import java.util.Arrays;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import simbad.sonar.check.Checks;

/**
 * Something along which levels may change smoothly, with a place on it for each ping: decibels at
 * knots, straight between them, normal about 0, correlated as Matern's function of order 3/2 says.
 */
public final class Along {
  private static final double JITTER = 1e-6;

  private final Axis axis;
  private final int curves;
  private final double[] place;

  /**
   * An axis.
   *
   * @param low place of the first knot
   * @param step from knot to knot, positive
   * @param knots how many, at least 2
   * @param wraps whether the first knot comes again after the last
   * @param length over which a curve stays alike, in units of the place
   */
  public record Axis(double low, double step, int knots, boolean wraps, double length) {
    /** Refuses what is no number. */
    public Axis {
      Checks.finite("low", low);
      Checks.positive("step", step);
      Checks.positive("length", length);
    }

    /** Returns an axis from 0 all round, in degrees. */
    public static Axis round(double step, double length) {
      Checks.positive("step", step);
      return new Axis(0, step, (int) Math.round(360 / step), true, length);
    }

    /** Returns an axis between two places. */
    public static Axis between(double low, double high, double step, double length) {
      Checks.finite("high", high);
      return new Axis(low, step, 2 + (int) Math.ceil((high - low) / step), false, length);
    }

    private double correlation(int one, int other) {
      int apart = Math.abs(one - other);
      int least = wraps ? Math.min(apart, knots - apart) : apart;
      return Prior.matern(least * step / length);
    }

    /** Returns where a knot is. */
    public double at(int knot) {
      return low + knot * step;
    }
  }

  /**
   * Creates it.
   *
   * @param axis of each curve
   * @param curves how many there are, of their own
   * @param place of each ping: knots behind the first of all curves, whole numbers at the knots;
   *     NaN where a ping has none
   */
  private Along(Axis axis, int curves, double[] place) {
    this.axis = axis;
    this.curves = curves;
    this.place = place;
  }

  /**
   * Places pings.
   *
   * @param axis of each curve
   * @param curve of each ping, from 0 on
   * @param at where on it each ping is; NaN where it is not
   */
  public static Along of(Axis axis, int[] curve, double[] at) {
    double[] place = new double[at.length];
    for (int ping = 0; ping < place.length; ping++) {
      double knot = (at[ping] - axis.low) / axis.step;
      double inside =
          axis.wraps
              ? knot - axis.knots * Math.floor(knot / axis.knots)
              : Math.max(0, Math.min(axis.knots - 1, knot));
      place[ping] = curve[ping] * axis.knots + Math.min(inside, Math.nextDown(axis.knots));
    }
    return new Along(axis, 1 + Arrays.stream(curve).max().orElse(0), place);
  }

  int size() {
    return curves * axis.knots;
  }

  /** Whether a ping has a place. */
  boolean has(int ping) {
    return !Double.isNaN(place[ping]);
  }

  /** The knot before a ping's place. */
  int knot(int ping) {
    return (int) place[ping];
  }

  /** The knot after it. */
  int next(int ping) {
    int knot = knot(ping);
    int first = knot - knot % axis.knots;
    int next = knot + 1 - first;
    return first + (axis.wraps ? next % axis.knots : Math.min(next, axis.knots - 1));
  }

  /** How much the knot after it counts there. */
  double share(int ping) {
    return place[ping] - knot(ping);
  }

  /** Returns the precision of all values where a curve's deviation is so many decibels. */
  RealMatrix precision(double spreadDb) {
    RealMatrix own = MatrixUtils.createRealMatrix(axis.knots, axis.knots);
    for (int i = 0; i < axis.knots; i++) {
      for (int j = 0; j < axis.knots; j++) {
        own.setEntry(i, j, spreadDb * spreadDb * axis.correlation(i, j));
      }
      own.addToEntry(i, i, JITTER * spreadDb * spreadDb);
    }
    RealMatrix inverse = Matrices.positive(own).getSolver().getInverse();
    RealMatrix all = MatrixUtils.createRealMatrix(size(), size());
    for (int curve = 0; curve < curves; curve++) {
      all.setSubMatrix(inverse.getData(), curve * axis.knots, curve * axis.knots);
    }
    return all;
  }
}
