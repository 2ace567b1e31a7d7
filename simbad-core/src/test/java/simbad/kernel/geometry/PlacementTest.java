package simbad.kernel.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class PlacementTest {
  private static final double EPSILON = 1e-12;

  @Test
  void heading_ofQuarterTurns() {
    checkHeading(0, 0);
    checkHeading(1, Math.PI / 2);
    checkHeading(2, Math.PI);
    checkHeading(3, -Math.PI / 2);
    checkHeading(-1, -Math.PI / 2);
    checkHeading(4, 0);
  }

  private static void checkHeading(int quarters, double expectedRad) {
    Placement placement = new Placement();
    placement.turnQuarters(quarters);
    assertEquals(expectedRad, placement.headingRad());
  }

  @Test
  void forward_afterLeftTurn_isMinusZ() {
    Placement placement = Placement.at(1, 2, 3);
    placement.turnAboutY(Math.PI / 2);
    checkPoint(placement, 1, 0, 0, 1, 2, 2);
  }

  @Test
  void xAxis_afterTurnAboutZ_isUp() {
    Placement placement = Placement.at(1, 2, 3);
    placement.turnAboutZ(Math.PI / 2);
    checkPoint(placement, 1, 0, 0, 1, 3, 3);
    assertFalse(placement.isUpright());
    placement.resetTurn();
    checkPoint(placement, 1, 0, 0, 2, 2, 3);
    assertTrue(placement.isUpright());
  }

  private static void checkPoint(
      Placement placement, double x, double y, double z, double outX, double outY, double outZ) {
    assertEquals(outX, placement.outerX(x, y, z), EPSILON);
    assertEquals(outY, placement.outerY(x, y, z), EPSILON);
    assertEquals(outZ, placement.outerZ(x, y, z), EPSILON);
  }

  @Property(seed = "20140914")
  void compose_placesPointsInTwoSteps(
      @ForAll @DoubleRange(min = -7, max = 7) double outerRad,
      @ForAll @DoubleRange(min = -7, max = 7) double innerRad,
      @ForAll @DoubleRange(min = -2, max = 2) double tiltRad) {
    Placement outer = Placement.at(1, -2, 0.5);
    outer.turnAboutY(outerRad);
    outer.turnAboutZ(tiltRad);
    Placement inner = Placement.at(-3, 0.25, 4);
    inner.turnAboutY(innerRad);
    Placement both = new Placement();
    both.compose(outer, inner);
    double x = inner.outerX(0.3, -0.7, 1.1);
    double y = inner.outerY(0.3, -0.7, 1.1);
    double z = inner.outerZ(0.3, -0.7, 1.1);
    assertEquals(outer.outerX(x, y, z), both.outerX(0.3, -0.7, 1.1), EPSILON);
    assertEquals(outer.outerY(x, y, z), both.outerY(0.3, -0.7, 1.1), EPSILON);
    assertEquals(outer.outerZ(x, y, z), both.outerZ(0.3, -0.7, 1.1), EPSILON);
  }

  @Property(seed = "20140914")
  void inner_undoesTurned(
      @ForAll @DoubleRange(min = -7, max = 7) double turnRad,
      @ForAll @DoubleRange(min = -7, max = 7) double tiltRad) {
    Placement placement = new Placement();
    placement.turnAboutY(turnRad);
    placement.turnAboutZ(tiltRad);
    double x = placement.turnedX(1, 2, 3);
    double y = placement.turnedY(1, 2, 3);
    double z = placement.turnedZ(1, 2, 3);
    assertEquals(1, placement.innerX(x, y, z), EPSILON);
    assertEquals(2, placement.innerY(x, y, z), EPSILON);
    assertEquals(3, placement.innerZ(x, y, z), EPSILON);
  }

  @Property(seed = "20140914")
  void invert_leadsBack(
      @ForAll @DoubleRange(min = -7, max = 7) double turnRad,
      @ForAll @DoubleRange(min = -2, max = 2) double tiltRad) {
    Placement there = Placement.at(1, -2, 0.5);
    there.turnAboutY(turnRad);
    there.turnAboutZ(tiltRad);
    Placement back = new Placement();
    back.invert(there);
    Placement both = new Placement();
    both.compose(back, there);
    assertEquals(0.3, both.outerX(0.3, -0.7, 1.1), EPSILON);
    assertEquals(-0.7, both.outerY(0.3, -0.7, 1.1), EPSILON);
    assertEquals(1.1, both.outerZ(0.3, -0.7, 1.1), EPSILON);
  }

  @Property(tries = 20, seed = "20140914")
  void manySmallTurns_stayARotation(@ForAll @IntRange(min = 1, max = 100_000) int turns) {
    Placement placement = new Placement();
    for (int i = 0; i < turns; i++) {
      placement.turnAboutY(0.0157);
    }
    assertEquals(0, Math.IEEEremainder(placement.headingRad() - turns * 0.0157, 2 * Math.PI), 1e-8);
    assertEquals(1, Math.hypot(placement.turnedX(1, 0, 0), placement.turnedZ(1, 0, 0)), 1e-9);
  }

  @Test
  void rotation_outsideMatrix_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> new Placement().rotation(3, 0));
  }

  @Test
  void toString_namesPosition() {
    assertEquals("(1.0, 2.0, 3.0; heading 0.0)", Placement.at(1, 2, 3).toString());
  }
}
