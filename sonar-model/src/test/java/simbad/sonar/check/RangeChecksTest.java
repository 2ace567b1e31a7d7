package simbad.sonar.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

class RangeChecksTest {
  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private static void assertRefused(String message, Executable check) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, check).getMessage());
  }

  @Test
  void whatIsInRangeComesBack() {
    double[] values = {1, INFINITE};
    double[][] rows = {values};
    List<Double> list = List.of(-1.0, -INFINITE);

    assertEquals(-INFINITE, Checks.number("v", -INFINITE));
    assertSame(values, Checks.numbers("v", values));
    assertSame(rows, Checks.numbers("v", rows));
    assertSame(list, Checks.numbers("v", list));
    assertEquals(OptionalDouble.empty(), Checks.finite("v", OptionalDouble.empty()));
    assertEquals(OptionalDouble.of(2), Checks.finite("v", OptionalDouble.of(2)));
    assertEquals(OptionalDouble.of(INFINITE), Checks.number("v", OptionalDouble.of(INFINITE)));
    assertEquals(INFINITE, Checks.positiveOrInfinite("v", INFINITE));
    assertEquals(INFINITE, Checks.notNegativeOrInfinite("v", INFINITE));
    assertEquals(0, Checks.notNegative("v", 0));
    assertEquals(1, Checks.share("v", 1));
  }

  @Test
  void nanIsNamedWithItsPlace() {
    assertRefused("v = NaN is not a number", () -> Checks.number("v", Double.NaN));
    assertRefused("v[1] = NaN is not a number", () -> Checks.numbers("v", 0, Double.NaN));
    assertRefused(
        "v[0] = NaN is not a number",
        () -> Checks.numbers("v", new double[][] {{1}, {Double.NaN}}));
    assertRefused("v[0] = NaN is not a number", () -> Checks.numbers("v", List.of(Double.NaN)));
    assertRefused("v = NaN is not finite", () -> Checks.finite("v", OptionalDouble.of(Double.NaN)));
  }

  @Test
  void theEndsOfRangesAreOpenOrClosedAsTheySay() {
    assertThrows(IllegalArgumentException.class, () -> Checks.positive("v", 0));
    assertThrows(IllegalArgumentException.class, () -> Checks.positive("v", INFINITE));
    assertThrows(IllegalArgumentException.class, () -> Checks.notNegative("v", -1e-300));
    assertThrows(IllegalArgumentException.class, () -> Checks.notNegative("v", INFINITE));
    assertThrows(IllegalArgumentException.class, () -> Checks.positiveOrInfinite("v", 0));
    assertThrows(IllegalArgumentException.class, () -> Checks.notNegativeOrInfinite("v", -1));
    assertThrows(IllegalArgumentException.class, () -> Checks.share("v", 1.0000001));
    assertThrows(IllegalArgumentException.class, () -> Checks.share("v", Double.NaN));
  }
}
