package simbad.scattering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EdgeCutTest {
  @ParameterizedTest
  @CsvSource({
    "0.025, true, true",
    "0.025, true, false",
    "0.025, false, true",
    "0.0016, true, true",
    "0.0003, false, true",
    "0.0001, true, true",
    "0.0001, false, false"
  })
  void elements_fillTheEdgeInOrder_andNoneIsTooLong(double lengthM, boolean begin, boolean end) {
    EdgeCut cut = new EdgeCut(lengthM, 0.2e-3, begin, end);
    assertEquals(0, cut.atM(0), 1e-15);
    assertEquals(lengthM, cut.atM(cut.count()), 1e-12);
    for (int e = 0; e < cut.count(); e++) {
      double elementM = cut.atM(e + 1) - cut.atM(e);
      assertTrue(elementM > 0 && elementM <= 0.2e-3 * (1 + 1e-9), "element " + e);
    }
  }

  @Test
  void sharpCorners_haveShortElements_bluntOnesDoNot() {
    EdgeCut cut = new EdgeCut(0.025, 0.2e-3, true, false);
    assertTrue(cut.atM(1) < 0.02e-3);
    assertEquals(0.2e-3, 0.025 - cut.atM(cut.count() - 1), 0.01e-3);
  }

  /** No jump in length, or differences of pressures would be of the first order only. */
  @Test
  void neighbours_areAlike() {
    EdgeCut cut = new EdgeCut(0.025, 0.2e-3, true, true);
    for (int e = 0; e < cut.count() - 1; e++) {
      double here = cut.atM(e + 1) - cut.atM(e);
      double next = cut.atM(e + 2) - cut.atM(e + 1);
      assertEquals(0, Math.log(next / here), 0.5, "element " + e);
    }
  }

  @Test
  void curves_getOneElementToAShortEdge() {
    assertEquals(1, new EdgeCut(0.1e-3, 0.2e-3, false, false).count());
  }
}
