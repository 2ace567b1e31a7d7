package simbad.sonar.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import net.jqwik.api.ForAll;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Seeded;

class AnglesTest {
  private static final double TURN = Angles.TURN_RAD;

  /** Angle, the same in (-180, 180], the same in [0, 360). */
  @ParameterizedTest
  @CsvSource({
    "0, 0, 0",
    "1, 1, 1",
    "-1, -1, 359",
    "90, 90, 90",
    "179, 179, 179",
    "180, 180, 180",
    "-180, 180, 180",
    "181, -179, 181",
    "-181, 179, 179",
    "270, -90, 270",
    "359, -1, 359",
    "360, 0, 0",
    "-360, 0, 0",
    "361, 1, 1",
    "725, 5, 5",
    "-725, -5, 355",
    "3600, 0, 0"
  })
  void bothIntervals_ofDegrees(double degrees, double signed, double positive) {
    double radians = Math.toRadians(degrees);
    assertEquals(signed, Math.toDegrees(Angles.signed(radians)), 1e-9);
    assertEquals(positive, Math.toDegrees(Angles.positive(radians)), 1e-9);
  }

  @Test
  void signed_atTheEndsOfItsInterval() {
    assertEquals(Math.PI, Angles.signed(Math.PI));
    assertEquals(Math.PI, Angles.signed(-Math.PI));
    assertEquals(Math.nextUp(-Math.PI), Angles.signed(Math.nextUp(-Math.PI)));
    assertEquals(Math.nextDown(Math.PI), Angles.signed(Math.nextDown(Math.PI)));
    // Just beyond half a turn: by so little on the other side.
    assertEquals(Math.nextUp(-Math.PI), Angles.signed(Math.nextUp(Math.PI)));
  }

  @Test
  void positive_atTheEndsOfItsInterval() {
    assertEquals(0, Angles.positive(TURN));
    assertEquals(0, Angles.positive(-TURN));
    assertEquals(Math.nextDown(TURN), Angles.positive(Math.nextDown(TURN)));
    // Too little below 0 for a number below a full turn.
    assertEquals(0, Angles.positive(-1e-20));
    assertEquals(0, Angles.positive(-Double.MIN_VALUE));
  }

  @Test
  void zero_hasNoSign() {
    assertEquals(new Heading(0.0), new Heading(-0.0));
    assertEquals(new Heading(0.0), new Heading(-TURN));
  }

  @Seeded
  void intervals_holdAnyFiniteAngle(@ForAll @DoubleRange(min = -1e300, max = 1e300) double any) {
    double signed = Angles.signed(any);
    double positive = Angles.positive(any);
    assertTrue(signed > -Math.PI && signed <= Math.PI, "signed " + signed);
    assertTrue(positive >= 0 && positive < TURN, "positive " + positive);
  }

  @Seeded
  void direction_isKept(@ForAll @DoubleRange(min = -1e4, max = 1e4) double any) {
    // 2 pi as a double is off by 2.4e-16: 1,600 turns add less than 1e-11.
    for (double same : new double[] {Angles.signed(any), Angles.positive(any)}) {
      assertEquals(Math.cos(any), Math.cos(same), 1e-11);
      assertEquals(Math.sin(any), Math.sin(same), 1e-11);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
  void everyAngle_notFinite_isRefused(double bad) {
    Refusal.check(() -> Angles.signed(bad), "angle = " + bad, "not finite");
    Refusal.check(() -> Angles.positive(bad), "angle = " + bad, "not finite");
    Refusal.check(() -> new Heading(bad), "angle = " + bad);
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "-90, -90", "180, 180", "-180, 180", "450, 90"})
  void degrees_comeBackNormalised(double degrees, double signed) {
    assertEquals(signed, Heading.ofDegrees(degrees).degrees(), 1e-12);
  }
}
