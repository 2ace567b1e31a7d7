package simbad.blindworld.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Checks of more than one number: each returns what it was given. */
class ManyChecksTest {

  @Test
  void numbers_mayBeInfinite_butHaveToBeNumbers() {
    double[] values = {1, Double.POSITIVE_INFINITY};
    assertSame(values, Checks.numbers("x", values));
    IllegalArgumentException fault =
        assertThrows(IllegalArgumentException.class, () -> Checks.numbers("x", 1, Double.NaN, 2));
    assertEquals("x: NaN, expected a number", fault.getMessage());
  }

  @Test
  void list_isCopied() {
    List<Double> values = new ArrayList<>(List.of(1.0, 2.0));
    List<Double> copy = Checks.numbers("x", values);
    values.add(3.0);
    assertEquals(List.of(1.0, 2.0), copy);
    values.add(Double.NaN);
    assertThrows(IllegalArgumentException.class, () -> Checks.numbers("x", values));
  }

  @Test
  void numberThatMayBeAbsent_isCheckedWhereItIs() {
    Optional<Double> absent = Optional.empty();
    assertEquals(absent, Checks.number("x", absent));
    assertEquals(Optional.of(2.0), Checks.number("x", Optional.of(2.0)));
    assertThrows(IllegalArgumentException.class, () -> Checks.number("x", Optional.of(Double.NaN)));
  }
}
