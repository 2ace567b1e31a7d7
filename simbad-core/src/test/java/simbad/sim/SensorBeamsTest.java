package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import org.junit.jupiter.api.Test;
import simbad.kernel.belt.BeltLayout;

class SensorBeamsTest {
  private static final double EPSILON = 1e-12;

  /** Unlike the angles by which quadrants go, these tell right from left. */
  @Test
  void angles_areThoseOfThePlaces() {
    double[][] places = {{1, 0, -1}, {1, 0, 1}, {-1, 0, 0}};
    double[][] ahead = {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    assertArrayEquals(
        new double[] {Math.PI / 4, -Math.PI / 4, Math.PI},
        SensorBeams.anglesRad(BeltLayout.of(places, ahead)),
        EPSILON);
  }

  @Test
  void angles_inTheMiddle_areThoseOfTheDirections() {
    assertArrayEquals(
        new double[] {0, Math.PI / 2, Math.PI, -Math.PI / 2},
        SensorBeams.anglesRad(BeltLayout.ring(0, 1, 4)),
        EPSILON);
  }

  @Test
  void idleRays_areStubs_unlessShownInFull() {
    BeltLayout layout = BeltLayout.ring(1, 2, 2);
    assertArrayEquals(new double[] {0.1, 0.1}, SensorBeams.idleLengthsM(layout, false), EPSILON);
    assertArrayEquals(new double[] {2, 2}, SensorBeams.idleLengthsM(layout, true), EPSILON);
  }
}
