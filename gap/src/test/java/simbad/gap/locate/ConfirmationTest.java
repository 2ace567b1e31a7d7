package simbad.gap.locate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class ConfirmationTest {
  /** Worked by hand: 0.01 * 4/1, 0.02 * 4/2, 0.03 * 4/3, 0.5 * 4/4, then least from behind. */
  @Test
  void falseDiscoveryRates_ofFourTests() {
    assertArrayEquals(
        new double[] {0.5, 0.04, 0.04, 0.04},
        Confirmation.falseDiscoveryRates(List.of(0.5, 0.01, 0.03, 0.02)),
        1e-12);
  }

  @Test
  void falseDiscoveryRates_ofNoTest() {
    assertArrayEquals(new double[0], Confirmation.falseDiscoveryRates(List.of()));
  }
}
