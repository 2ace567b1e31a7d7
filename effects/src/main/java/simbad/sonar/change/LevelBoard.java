package simbad.sonar.change;

import simbad.sonar.check.Checks;
import simbad.sonar.ping.ArrivalChange;
import simbad.sonar.ping.Arrivals;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelEcho;
import simbad.sonar.ping.Moment;

/**
 * A flat board that is not in the scene, under the level law. Either side is a mirror: what comes
 * back from a distance d has gone a way of 2 d and spread once, where that of a target of 0 dB has
 * spread twice, so it is as that of a target of 20 lg(d / 2 m) dB. Before a sensor that stands
 * beside it the board's edge cuts the mirror image off by the loss behind a knife edge (ITU-R
 * Recommendation P.526), with both ways of a length d.
 *
 * @param xM x of its middle, world frame, metres
 * @param zM z of its middle, world frame, metres
 * @param normalRad heading that one side faces; the other faces the opposite one
 * @param halfWidthM half its width, metres
 * @param reflectedDb how much less than all it sends back, decibels; negative infinity is neutral
 */
public record LevelBoard(
    double xM, double zM, double normalRad, double halfWidthM, double reflectedDb)
    implements ArrivalChange {
  /** Of 40 kHz in air of 343 m/s. */
  private static final double WAVELENGTH_M = 0.0086;

  /** So far before the edge the loss is none. */
  private static final double CLEAR = -0.78;

  /** Checks the figures; NaN is refused. */
  public LevelBoard {
    Checks.finite("xM", xM);
    Checks.finite("zM", zM);
    Checks.finite("normalRad", normalRad);
    Checks.notNegative("halfWidthM", halfWidthM);
    Checks.number("reflectedDb", reflectedDb);
  }

  @Override
  public void add(Moment moment, Arrivals arrivals) {
    if (reflectedDb == Double.NEGATIVE_INFINITY) {
      return;
    }
    Geometry geometry = moment.geometry();
    double dx = geometry.xM(moment.ping()) - xM;
    double dz = geometry.zM(moment.ping()) - zM;
    double normalX = Math.cos(normalRad);
    double normalZ = -Math.sin(normalRad);
    double before = dx * normalX + dz * normalZ;
    double along = dz * normalX - dx * normalZ;
    double beside = along - Math.max(-halfWidthM, Math.min(halfWidthM, along));
    double toX = -before * normalX + beside * normalZ;
    double toZ = -before * normalZ - beside * normalX;
    double distance = Math.sqrt(toX * toX + toZ * toZ);
    if (distance > 0) {
      double beyond = (Math.abs(along) - halfWidthM) * 2 / Math.sqrt(WAVELENGTH_M * distance);
      double spreading = 20 * Math.log10(distance / 2);
      LevelEcho.add(moment, arrivals, toX, toZ, reflectedDb + spreading - knifeEdgeDb(beyond));
    }
  }

  private static double knifeEdgeDb(double beyond) {
    if (beyond <= CLEAR) {
      return 0;
    }
    double shifted = beyond - 0.1;
    return 6.9 + 20 * Math.log10(Math.sqrt(shifted * shifted + 1) + shifted);
  }
}
