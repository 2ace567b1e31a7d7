package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;

class SymmetryTest {
  /** 144 bearings, 2.5 degrees apart. */
  private static final int TURN = 144;

  @Test
  void aSquareAnswersAlikeAtEightBearings() {
    Symmetry square = Symmetry.of(rectangle(0.1, 0.1));

    assertEquals(TURN / 8 + 1, square.orbits());
    assertEquals(square.orbit(TURN / 4 + 4), square.orbit(4));
    assertEquals(square.orbit(TURN - 4), square.orbit(4));
    assertNotEquals(square.orbit(5), square.orbit(4));
  }

  @Test
  void aPlateAnswersAlikeAtFour() {
    Symmetry plate = Symmetry.of(rectangle(0.1, 0.004));

    assertEquals(TURN / 4 + 1, plate.orbits());
    assertNotEquals(plate.orbit(TURN / 4), plate.orbit(0));
  }

  @Test
  void aDiscAnswersAlikeAllRound() {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < 90; i++) {
      double angle = i * Math.PI / 45;
      corners.add(new Point(0.05 * Math.cos(angle), 0.05 * Math.sin(angle)));
    }

    assertEquals(1, Symmetry.of(Outline.of(corners)).orbits());
  }

  @Test
  void whatHasNoSymmetryKeepsAllItsBearings() {
    Outline wedge =
        Outline.of(List.of(new Point(-0.02, -0.03), new Point(0.09, -0.03), new Point(0, 0.06)));

    assertEquals(TURN, Symmetry.of(wedge).orbits());
  }

  /** Five per cent of the longer side are no square: the tolerance is half of that. */
  @Test
  void nearlyASquareIsNone() {
    assertEquals(TURN / 4 + 1, Symmetry.of(rectangle(0.1, 0.09)).orbits());
  }

  private static Outline rectangle(double alongX, double alongZ) {
    double x = alongX / 2;
    double z = alongZ / 2;
    return Outline.of(
        List.of(new Point(x, z), new Point(x, -z), new Point(-x, -z), new Point(-x, z)));
  }
}
