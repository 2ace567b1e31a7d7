package simbad.scattering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.scattering.RigidScatterer.Formulation;

class RigidScattererTest {
  private static final double RADIUS_M = 0.0127;

  /** Relative error of the echo of a cylinder with so many elements. */
  private static double error(double ka, int elements, Formulation formulation) {
    double k = ka / RADIUS_M;
    RigidScatterer cylinder =
        RigidScatterer.of(
            List.of(Cases.circle(RADIUS_M, elements)), k, RADIUS_M, formulation); // one to an edge
    assertEquals(elements, cylinder.elements());
    double echo = cylinder.backscatter(new double[] {0.3})[0];
    return echo / CylinderSeries.backscatter(k, RADIUS_M) - 1;
  }

  private static int elements(double ka) {
    return 4 * (int) Math.max(40, 6 * ka);
  }

  /** Within 1 % of the exact series; the last five are resonances of the inside or next to one. */
  @ParameterizedTest
  @ValueSource(
      doubles = {
        0.5, 1, 1.7, 3, 4.5, 6, 8, 10, 13, 16.3, 20, 2.4048, 3.8317, 5.5201, 8.6537, 19.9944
      })
  void cylinder_isWithinOnePercentOfTheSeries(double ka) {
    assertEquals(0, error(ka, elements(ka), Formulation.BURTON_MILLER), 0.01);
  }

  /** J_1 and J_n have zeros at these ka: there the plain equation fails, whatever the elements. */
  @Test
  void resonances_breakThePlainEquationOnly() {
    double plain = 0;
    double coupled = 0;
    for (double ka = 19.9; ka <= 20.05; ka += 0.01) {
      plain = Math.max(plain, Math.abs(error(ka, 320, Formulation.PLAIN)));
      coupled = Math.max(coupled, Math.abs(error(ka, 320, Formulation.BURTON_MILLER)));
    }
    assertTrue(plain > 0.1, "plain: " + plain);
    assertTrue(coupled < 0.01, "Burton and Miller: " + coupled);
  }

  /** Second order: half the element, a quarter of the error. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 5})
  void error_fallsWithTheElements(double ka) {
    double coarse = Math.abs(error(ka, 96, Formulation.BURTON_MILLER));
    double fine = Math.abs(error(ka, 192, Formulation.BURTON_MILLER));
    assertTrue(fine < 0.35 * coarse, coarse + " then " + fine);
  }

  /** Ripple over the bearings of what has none. */
  @Test
  void cylinder_echoesAlikeAllRound() {
    double[] bearings = {0, 0.1, 0.2, 1, 2, 3, 4, 5, 6};
    double[] echo =
        RigidScatterer.of(List.of(Cases.circle(RADIUS_M, 60)), 732, 0.25e-3).backscatter(bearings);
    for (double value : echo) {
      assertEquals(echo[0], value, 0.007 * echo[0]);
    }
  }
}
