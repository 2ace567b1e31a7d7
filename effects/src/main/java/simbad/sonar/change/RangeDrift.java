package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.RangeChange;

/**
 * Ranges drift with the time since the first ping: by an amount, in proportion to the range, or
 * both. At the first ping they are right.
 *
 * @param shiftM by how much every range is longer in the end, metres; for a drift that does not
 *     settle, after a second; 0 is neutral
 * @param share by what share of itself it is longer then; over -1; 0 is neutral
 * @param settlingS after how long all but a share of 1/e of it is there, seconds, positive;
 *     infinity for a drift that does not settle
 */
public record RangeDrift(double shiftM, double share, double settlingS) implements RangeChange {
  /** Checks the figures; NaN is refused. */
  public RangeDrift {
    Checks.finite("shiftM", shiftM);
    Checks.finite("share", share);
    Checks.positiveOrInfinite("settlingS", settlingS);
    if (!(share > -1)) {
      throw new IllegalArgumentException("share = " + share + " is not over -1");
    }
  }

  @Override
  public RangeChange at(Geometry geometry, int ping) {
    return after(geometry.sinceStartS(ping));
  }

  /**
   * Returns the change of ranges after a time.
   *
   * @param sinceS since the first ping, seconds, at least 0
   */
  public RangeChange after(double sinceS) {
    double arrived =
        settlingS == Double.POSITIVE_INFINITY ? sinceS : -Math.expm1(-sinceS / settlingS);
    return new Line(Math.max(LEAST, 1 + share * arrived), shiftM * arrived);
  }

  /** A drift that never ends would turn ranges round. */
  private static final double LEAST = 0.01;

  /** What grows with the range is a scale, and comes before what is added. */
  @Override
  public int order() {
    return share == 0 ? 1 : 0;
  }

  /** Ranges times a factor, then longer by an amount. */
  private record Line(double factor, double shiftM) implements RangeChange {
    @Override
    public int order() {
      return 1;
    }

    @Override
    public double meanM(double rangeM) {
      return factor * rangeM + shiftM;
    }

    @Override
    public double rangeM(double meanM) {
      return (meanM - shiftM) / factor;
    }
  }
}
