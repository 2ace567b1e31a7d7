package simbad.blindworld.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import simbad.blindworld.generate.Order;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.wave.Counter;
import simbad.blindworld.wave.WavePing;
import simbad.blindworld.world.Beam;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Setup;

class ChecksTest {
  private static final double INFINITE = Double.POSITIVE_INFINITY;

  /** Takes some values, as they are, and refuses others with what was expected. */
  private static void check(
      DoubleUnaryOperator check, String expected, List<Double> taken, List<Double> refused) {
    for (double value : taken) {
      assertEquals(value, check.applyAsDouble(value));
    }
    for (double value : refused) {
      IllegalArgumentException fault =
          assertThrows(IllegalArgumentException.class, () -> check.applyAsDouble(value));
      assertEquals("x: " + value + ", expected " + expected, fault.getMessage());
    }
  }

  @Test
  void values_areTakenAsTheyAreOrRefusedWithWhatWasExpected() {
    double nan = Double.NaN;
    check(x -> Checks.number("x", x), "a number", List.of(-INFINITE, -1.0, INFINITE), List.of(nan));
    check(
        x -> Checks.finite("x", x),
        "a finite number",
        List.of(-1.0, 0.0),
        List.of(nan, INFINITE, -INFINITE));
    check(
        x -> Checks.positive("x", x),
        "a finite number above 0",
        List.of(Double.MIN_VALUE),
        List.of(nan, 0.0, -1.0, INFINITE));
    check(
        x -> Checks.notNegative("x", x),
        "a finite number from 0 on",
        List.of(0.0, 1.0),
        List.of(nan, -Double.MIN_VALUE, INFINITE));
    check(x -> Checks.limit("x", x), "above 0", List.of(1.0, INFINITE), List.of(nan, 0.0));
    check(x -> Checks.share("x", x), "in [0, 1]", List.of(0.0, 1.0), List.of(nan, -0.1, 1.1));
  }

  /** NaN comes in nowhere, which a test of cli's walks; these are values out of range. */
  @Test
  void doors_refuseWhatIsOutOfRange() {
    refused(() -> new Order.Sizes(0, 1));
    refused(() -> new Robot.Beliefs(-0.1, 0, 1, 1));
    refused(() -> new Robot.Scatter(-0.1, 0));
    refused(() -> new Counter(0, 0, 0, 0));
    refused(() -> new WavePing(new Chance(1), 0, 0, 1.5));
    refused(() -> new Beam(0, -0.1));
    refused(() -> new Setup(0.1, 1.5, 0, 0, 1, 0, new Setup.Ripple(0, 1, 0), 0, 0));
  }

  private static void refused(Runnable door) {
    assertThrows(IllegalArgumentException.class, door::run);
  }
}
