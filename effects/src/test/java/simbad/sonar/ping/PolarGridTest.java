package simbad.sonar.ping;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import simbad.sonar.frame.Angles;

class PolarGridTest {
  private static final PolarGrid GRID = new PolarGrid(8);

  /** Straight over the distance, and over each eighth of a turn. */
  private static double plane(int bearing, int distance) {
    return 3 * bearing + 100 * GRID.distanceM(distance);
  }

  @Test
  void at_ofWhatIsStraight_isExactBetweenItsValues() {
    for (double eighths : new double[] {0, 0.25, 3.5, 6.99}) {
      for (double distanceM : new double[] {0.1, 0.15, 1, 1.13, 4.5}) {
        double bearingRad = eighths * Angles.TURN_RAD / 8;
        double expected = 3 * eighths + 100 * distanceM;
        assertEquals(expected, GRID.at(PolarGridTest::plane, bearingRad, distanceM), 1e-9);
      }
    }
  }

  @Test
  void at_behindTheLastBearing_goesBackToTheFirst() {
    double bearingRad = 7.5 * Angles.TURN_RAD / 8;
    assertEquals(10.5 + 100, GRID.at(PolarGridTest::plane, bearingRad, 1), 1e-9);
    assertEquals(100, GRID.at(PolarGridTest::plane, Angles.TURN_RAD, 1), 1e-9);
  }

  @Test
  void at_beforeAndBehindAllDistances_isConstant() {
    assertEquals(10, GRID.at(PolarGridTest::plane, 0, 0.01), 1e-9);
    assertEquals(100 * GRID.furthestM(), GRID.at(PolarGridTest::plane, 0, 50), 1e-9);
  }

  @Test
  void cells_areEachTheirOwn_andUnknownAtFirst() {
    double[] values = GRID.unknown();
    for (int bearing = 0; bearing < 8; bearing++) {
      for (int distance = 0; distance < PolarGrid.distancesM().length; distance++) {
        assertTrue(Double.isNaN(values[GRID.cell(bearing, distance)]));
        values[GRID.cell(bearing, distance)] = 0;
      }
    }
    for (double value : values) {
      assertEquals(0, value);
    }
  }
}
