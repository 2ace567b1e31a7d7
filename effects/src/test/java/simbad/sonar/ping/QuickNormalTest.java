package simbad.sonar.ping;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import simbad.sonar.model.NormalDistribution;

class QuickNormalTest {
  @Test
  void cumulative_isTheDistributionTo1e11_andNeverFalls() {
    double before = 0;
    for (double x = -9; x <= 9; x += 0.00037) {
      double quick = QuickNormal.cumulative(x);
      assertEquals(NormalDistribution.cumulative(x), quick, 1e-11, "at " + x);
      assertTrue(quick >= before - 1e-15, "at " + x);
      before = quick;
    }
  }

  @Test
  void cumulative_atTheEnds() {
    assertEquals(0, QuickNormal.cumulative(Double.NEGATIVE_INFINITY));
    assertEquals(1, QuickNormal.cumulative(Double.POSITIVE_INFINITY));
    assertEquals(0.5, QuickNormal.cumulative(0), 1e-15);
  }
}
