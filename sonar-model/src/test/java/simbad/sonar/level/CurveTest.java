package simbad.sonar.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Refusal;

class CurveTest {
  private static final Curve CURVE = Curve.of(-1, 4, 0, 2, 3, 8, 3.5, -1);

  /** Straight between the points (-1, 4), (0, 2), (3, 8), (3.5, -1), constant beyond. */
  @ParameterizedTest
  @CsvSource({
    "-Infinity, 4",
    "-2, 4",
    "-1, 4",
    "-0.25, 2.5",
    "0, 2",
    "1, 4",
    "2.5, 7",
    "3, 8",
    "3.25, 3.5",
    "3.5, -1",
    "9, -1",
    "Infinity, -1"
  })
  void value_betweenAndBeyondThePoints(double at, double expected) {
    assertEquals(expected, CURVE.at(at), 1e-12);
  }

  @Test
  void ends_areFound() {
    assertEquals(-1, CURVE.least());
    assertEquals(8, CURVE.greatest());
    assertEquals(4, CURVE.size());
    assertEquals(3.5, CURVE.x(3));
    assertEquals(-1, CURVE.y(3));
  }

  @Test
  void constant_isOnePoint() {
    assertEquals(0.3, Curve.constant(0.3).at(-7));
    assertEquals(0.3, Curve.constant(0.3).at(7));
  }

  @Test
  void equalPoints_equalCurves() {
    assertEquals(CURVE, Curve.of(-1, 4, 0, 2, 3, 8, 3.5, -1));
    assertEquals(CURVE.hashCode(), Curve.of(-1, 4, 0, 2, 3, 8, 3.5, -1).hashCode());
    assertNotEquals(CURVE, Curve.of(-1, 4, 0, 2));
    assertEquals("Curve[[0.0, 1.0], [2.0, 3.0]]", Curve.of(0, 1, 2, 3).toString());
  }

  @Test
  void wrongPoints_areRefused() {
    Refusal.check(() -> Curve.of(), "points = 0 numbers");
    Refusal.check(() -> Curve.of(1, 2, 3), "points = 3 numbers");
    Refusal.check(() -> Curve.of(1, 2, 1, 3), "x = 1.0 does not rise from 1.0");
    Refusal.check(() -> Curve.of(1, Double.NaN), "NaN in a curve is not finite");
    Refusal.check(() -> Curve.of(Double.POSITIVE_INFINITY, 1), "Infinity in a curve");
  }
}
