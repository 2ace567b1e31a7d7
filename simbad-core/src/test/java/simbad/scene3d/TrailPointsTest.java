package simbad.scene3d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class TrailPointsTest {
  private static final int CAPACITY = 64;
  private static final double SPACING_M = 0.01;
  private final TrailPoints points = new TrailPoints(CAPACITY, SPACING_M);

  private void drive(double fromM, double toM) {
    for (double x = fromM; x < toM; x += 0.001) {
      points.visit(x, 0, 0);
    }
  }

  @Test
  void nearPlaces_moveTheLastPointAlone() {
    points.visit(0, 0, 0);
    assertFalse(points.visit(0.004, 0, 0));
    assertEquals(2, points.size());
    assertEquals(0.004, points.get(1, 0));
    assertTrue(points.visit(0.02, 0, 0.01));
    assertEquals(3, points.size());
    assertEquals(0.01, points.get(1, 2));
  }

  @Test
  void longWay_isThinned_andKeepsItsBeginning() {
    drive(0, 1.5);
    assertTrue(points.size() <= CAPACITY);
    assertEquals(4 * SPACING_M, points.spacingM(), 1e-12);
    assertTrue(points.get(0, 0) < 2 * SPACING_M, "where it began: " + points.get(0, 0));
    assertEquals(1.5, points.get(points.size() - 1, 0), 0.002);
  }

  /** Wider gaps would cut corners: what is oldest is forgotten instead. */
  @Test
  void endlessWay_losesItsBeginning_notItsShape() {
    drive(0, 200);
    assertTrue(points.size() <= CAPACITY);
    assertEquals(4 * SPACING_M, points.spacingM(), 1e-12);
    for (int i = 1; i < points.size(); i++) {
      double gapM = points.get(i, 0) - points.get(i - 1, 0);
      assertTrue(gapM >= 0 && gapM <= 4 * SPACING_M + 0.002, "gap " + gapM);
    }
    assertEquals(200, points.get(points.size() - 1, 0), 0.002);
  }

  @Test
  void clear_forgetsAll_andIsFineAgain() {
    drive(0, 5);
    points.clear();
    assertEquals(0, points.size());
    assertEquals(SPACING_M, points.spacingM());
    assertEquals(0, points.jumpM(9, 9, 9));
  }

  @Test
  void jump_isFromWhereItWasLast() {
    points.visit(1, 0, 0);
    points.visit(1.005, 0, 0);
    assertEquals(2, points.jumpM(3.005, 0, 0), 1e-12);
  }
}
