package simbad.sonar.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;

class OverlapTest {
  private static Outline square(double side) {
    double h = side / 2;
    return Outline.of(
        List.of(new Point(h, h), new Point(h, -h), new Point(-h, -h), new Point(-h, h)));
  }

  /** A square of 1 m beside one of another size that is moved along x. */
  @ParameterizedTest
  @CsvSource({
    "0.9, 1, true",
    "1.1, 1, false",
    "1, 1, false",
    "0, 0.2, true",
    "0, 3, true",
    "0, 1, true",
    "0.65, 0.2, false"
  })
  void squares_overlapWhenTheyCrossOrHold(double shiftM, double side, boolean expected) {
    Outline other = square(side).placed(new Placement(shiftM, 0, 0));
    assertEquals(expected, Overlap.of(square(1), other));
    assertEquals(expected, Overlap.of(other, square(1)));
  }

  /** Turned by an eighth its corner reaches 0.707 m. */
  @Test
  void turning_counts() {
    Outline turned = square(1).placed(new Placement(1.15, 0, Math.PI / 4));
    assertTrue(Overlap.of(square(1), turned));
    assertEquals(
        false, Overlap.of(square(1), square(1).placed(new Placement(1.25, 0, Math.PI / 4))));
  }

  /** A bow tie crosses itself; two bodies joined by a line only touch. */
  @Test
  void crossing_isNotTouching() {
    Outline bow =
        Outline.of(List.of(new Point(0, 0), new Point(1, 1), new Point(1, 0), new Point(0, 1)));
    assertEquals(Optional.of(new Crossing(0, 2)), Crossing.find(bow));
    assertEquals(Optional.of(new Crossing(0, 2)), Crossing.findCrossed(bow));
    Outline pair = Outline.joined(List.of(square(1), square(1).placed(new Placement(3, 0, 0))));
    assertTrue(Crossing.find(pair).isPresent());
    assertEquals(Optional.empty(), Crossing.findCrossed(pair));
    assertEquals(Optional.empty(), Crossing.find(square(1)));
  }
}
