package simbad.figures.page;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AxisScaleTest {
  private static List<String> labels(AxisScale axis) {
    return axis.ticks().stream().map(axis::label).toList();
  }

  @Test
  void ticks_areRoundNumbers() {
    assertEquals(List.of("0", "1", "2", "3", "4"), labels(AxisScale.over(0, 3.2, 4)));
    assertEquals(
        List.of("0.00", "0.05", "0.10", "0.15").subList(1, 4),
        labels(AxisScale.over(0.01, 0.14, 4)).subList(1, 4));
    assertEquals(
        List.of("\u2212200", "\u2212100", "0", "100"), labels(AxisScale.over(-130, 80, 3)));
  }

  @ParameterizedTest
  @CsvSource({"0.9, 1", "1, 1", "1.01, 2", "3, 5", "6, 10", "0.021, 0.05", "4000, 5000", "0, 1"})
  void step_isOneTwoOrFive(double size, double step) {
    assertEquals(step, AxisScale.roundStep(size), step * 1e-9);
  }

  /** Data that end on a tick need no step more, whatever the binary fractions. */
  @ParameterizedTest
  @CsvSource({"0, 0.3, 3", "0, 0.7, 7", "-0.3, 0.3, 6", "1e-9, 3e-9, 4", "100, 100, 4"})
  void axis_coversItsData(double low, double high, int ticks) {
    AxisScale axis = AxisScale.over(low, high, ticks);
    assertTrue(axis.low() <= low + axis.step() * 1e-6 && axis.high() >= high - axis.step() * 1e-6);
    assertTrue(axis.high() > axis.low());
    assertTrue(axis.ticks().size() <= ticks + 3, axis.toString());
  }
}
