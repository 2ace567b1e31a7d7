package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.junit.jupiter.api.Test;

class AlongTest {
  private static final double EXACT = 1e-9;

  /** What a curve is at a ping, from its values at the knots. */
  private static double at(Along along, int ping, double[] atKnots) {
    return (1 - along.share(ping)) * atKnots[along.knot(ping)]
        + along.share(ping) * atKnots[along.next(ping)];
  }

  @Test
  void isStraightBetweenKnots_constantBeyond() {
    Along along =
        Along.of(Along.Axis.between(1, 3, 0.5, 1), new int[5], new double[] {1, 1.75, 0.2, 3, 99});
    double[] rising = {0, 1, 2, 3, 4, 5};
    double[] told = {0, 1.5, 0, 4, 5};
    for (int ping = 0; ping < told.length; ping++) {
      assertEquals(told[ping], at(along, ping, rising), EXACT);
    }
  }

  @Test
  void allRound_theFirstKnotComesAfterTheLast() {
    Along along =
        Along.of(Along.Axis.round(90, 60), new int[3], new double[] {315, -45, 359.999999999});
    double[] values = {8, 0, 0, 4};
    assertEquals(6, at(along, 0, values), EXACT);
    assertEquals(6, at(along, 1, values), EXACT);
    assertEquals(8, at(along, 2, values), 1e-6);
  }

  @Test
  void eachCurveHasKnotsOfItsOwn_andPingsWithoutAPlaceNone() {
    Along along =
        Along.of(Along.Axis.round(90, 60), new int[] {0, 1, 0}, new double[] {90, 90, Double.NaN});
    assertEquals(8, along.size());
    assertEquals(1, along.knot(0));
    assertEquals(5, along.knot(1));
    assertTrue(along.has(1));
    assertFalse(along.has(2));
  }

  /** Inverted again, it is Matern's function of order 3/2 between knots, by hand. */
  @Test
  void precision_isThatOfMatern() {
    Along along = Along.of(Along.Axis.round(90, 60), new int[1], new double[1]);
    RealMatrix covariance = MatrixUtils.inverse(along.precision(3));
    double x = Math.sqrt(3) * 90 / 60;
    assertEquals(9, covariance.getEntry(0, 0), 1e-4);
    assertEquals(9 * (1 + x) * Math.exp(-x), covariance.getEntry(0, 1), 1e-4);
    assertEquals(covariance.getEntry(0, 1), covariance.getEntry(0, 3), 1e-9, "both ways round");
  }
}
