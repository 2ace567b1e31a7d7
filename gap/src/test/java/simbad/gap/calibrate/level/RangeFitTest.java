package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class RangeFitTest {
  private static final double STEP_M = 0.01;

  /** Weak echoes read 2 cm long and scatter by 9 mm, strong ones neither; one in thirty is wild. */
  private static RangeFit fit(int echoes) {
    Random random = new Random(4);
    double[] excess = new double[echoes];
    double[] beyond = new double[echoes];
    for (int i = 0; i < echoes; i++) {
      excess[i] = 24 * random.nextDouble();
      double weak = Math.max(0, 1 - excess[i] / 14);
      double noise = random.nextInt(30) == 0 ? 0.1 : 0.003 + 0.006 * weak;
      double range = 0.02 * weak + noise * random.nextGaussian() + 0.37 * i;
      beyond[i] = Math.floor(range / STEP_M) * STEP_M + STEP_M / 2 - 0.37 * i;
    }
    return new RangeFit(excess, beyond, STEP_M, 0.005);
  }

  @Test
  void theWalkIsFoundThroughStepsAndStrays() {
    double[] walk = fit(3000).walkM();

    assertEquals(0.02, walk[0], 0.003);
    assertEquals(0.02 * 6 / 14, walk[2], 0.002);
    assertEquals(0, walk[4], 0.002);
  }

  @Test
  void weakEchoesScatterMore() {
    double[] noise = fit(3000).noiseM();

    assertBetween(0.0065, 0.01, noise[0]);
    assertBetween(0.002, 0.0055, noise[2]);
  }

  @Test
  void withoutEchoesItIsAsBelieved() {
    RangeFit none = fit(0);

    assertArrayEquals(new double[5], none.walkM(), 0);
    assertArrayEquals(new double[] {0.005, 0.005, 0.005}, none.noiseM(), 1e-6);
  }

  private static void assertBetween(double low, double high, double value) {
    assertTrue(value >= low && value <= high, value + " is not in [" + low + ", " + high + "]");
  }
}
