package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class BenjaminiHochbergTest {
  /** Worked by hand: 0.01 * 4/1, 0.02 * 4/2, 0.03 * 4/3, 0.5 * 4/4, then least from behind. */
  @Test
  void falseDiscoveryRates_ofFourTests() {
    assertArrayEquals(
        new double[] {0.5, 0.04, 0.04, 0.04},
        BenjaminiHochberg.falseDiscoveryRates(List.of(0.5, 0.01, 0.03, 0.02)),
        1e-12);
  }

  @Test
  void falseDiscoveryRates_ofNoTest() {
    assertArrayEquals(new double[0], BenjaminiHochberg.falseDiscoveryRates(List.of()));
  }
}
