package simbad.gap.slice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;

/** Variables cut into bins: by names, by round widths, by as many pings each, by pairs. */
class AxisTest {
  private static List<Integer> bins(Axis axis, int pings) {
    return IntStream.range(0, pings).map(axis::bin).boxed().toList();
  }

  private static Axis numbered(double... values) {
    return Axis.numbered("d", values.length, i -> values[i], 1e-6);
  }

  private static Axis quantiles(int bins, double... values) {
    return Axis.quantiles("d", values.length, bins, i -> values[i]);
  }

  private static Interval ends(Axis axis, int from, int to) {
    return axis.condition(from, to).interval().orElseThrow();
  }

  /** What differs in its last binary digits alone is one number. */
  @Test
  void numbersThatAreTheSame_haveOneBin() {
    for (double[] same : new double[][] {{0, 3e-15, 1e-14}, {2, 2 + 9e-7}, {-0.5}, {}}) {
      Axis axis = numbered(same);
      assertEquals(Math.min(1, same.length), axis.count());
      for (int i = 0; i < same.length; i++) {
        Interval ends = ends(axis, 0, 1);
        assertTrue(same[i] >= ends.low() && same[i] < ends.high(), ends::toString);
      }
    }
    assertTrue(numbered(2, 2 + 2e-6).count() > 1);
  }

  /** Angles off the axis that rounded poses make are one number, also about a round one. */
  @ParameterizedTest
  @CsvSource({"-0.002, 0.01", "0.96, 1.03", "3, 3.09", "-5.04, -4.95"})
  void numbersThatDifferByRounding_haveOneBin(double low, double high) {
    double[] values = {low, high, low};
    assertEquals(1, Axis.numbered("off_axis_deg", 3, i -> values[i], 0.1).count());
    assertTrue(Axis.numbered("off_axis_deg", 3, i -> values[i], 0.001).count() > 1);
  }

  @Test
  void names_haveABinEach_inUseOrNot() {
    Axis axis = Axis.named("run", 4, List.of("a", "b", "c"), i -> i - 1);
    assertEquals("run", axis.variable());
    assertEquals(3, axis.count());
    assertFalse(axis.ordered());
    assertEquals(List.of(-1, 0, 1, 2), bins(axis, 4));
    assertEquals(
        new Place.Condition("run", Optional.empty(), Optional.of("b")), axis.condition(1, 2));
    assertEquals(5, Axis.named("run", 0, List.of("a", "b", "c", "d", "e"), i -> i).count());
  }

  @Test
  void binNumbers_areTheirNames() {
    Axis axis = Axis.binned("cell", 3, 12, i -> 5 * i);
    assertEquals(12, axis.count());
    assertEquals(List.of(0, 5, 10), bins(axis, 3));
    assertEquals(Optional.of("10"), axis.condition(10, 11).name());
    assertEquals(Optional.empty(), axis.condition(10, 11).interval());
  }

  /** Of ten values two to a bin; where seven do not go into three, the last bins hold more. */
  @Test
  void quantiles_haveAsManyPingsEach() {
    Axis even = quantiles(5, 9, 0, 8, 1, 7, 2, 6, 3, 5, 4);
    assertEquals(5, even.count());
    assertEquals(List.of(4, 0, 4, 0, 3, 1, 3, 1, 2, 2), bins(even, 10));
    assertEquals(List.of(0, 0, 1, 1, 2, 2, 2), bins(quantiles(3, 1, 2, 3, 4, 5, 6, 7), 7));
    assertEquals(List.of(0, 0), bins(quantiles(1, 3, 4), 2));
  }

  @Test
  void quantiles_leaveOutWhatIsNotFinite() {
    Axis axis = quantiles(2, 1, Double.NaN, 2, Double.POSITIVE_INFINITY, 3, 4);
    assertEquals(List.of(0, -1, 0, -1, 1, 1), bins(axis, 6));
    Axis none = quantiles(4, Double.NaN, Double.NEGATIVE_INFINITY);
    assertEquals(4, none.count());
    assertEquals(List.of(-1, -1), bins(none, 2));
  }

  /** Equal values are never parted, though one bin holds more then. */
  @Test
  void quantiles_keepEqualValuesTogether() {
    assertEquals(List.of(0, 1, 1, 1), bins(quantiles(2, 0, 5, 5, 5), 4));
  }

  @Test
  void times_hasABinForEachPair() {
    Axis one = Axis.binned("one", 4, 3, i -> i - 1);
    Axis other = Axis.binned("other", 4, 5, i -> i == 3 ? -1 : i + 2);
    Axis both = one.times(other);
    assertEquals("one x other", both.variable());
    assertEquals(15, both.count());
    // Neither axis may lack the ping: 0 * 5 + 3 and 1 * 5 + 4 are left.
    assertEquals(List.of(-1, 3, 9, -1), bins(both, 4));
    assertEquals(Optional.of("9"), both.condition(9, 10).name());
  }

  /** From 3 to 83 in 40 steps: 2 each, from the last whole step below 3 on. */
  @Test
  void numbers_areCutFromARoundNumberOn() {
    Axis axis = numbered(3, 83, 3.9, 4, 50);
    assertTrue(axis.ordered());
    assertEquals(41, axis.count());
    assertEquals(List.of(0, 40, 0, 1, 24), bins(axis, 5));
    assertEquals(
        new Place.Condition("d", Optional.of(new Interval(2, 4)), Optional.empty()),
        axis.condition(0, 1));
    assertEquals(new Interval(4, 84), ends(axis, 1, 41));
  }

  /** The least of 1, 2, 2.5, 5 and 10 times a power of ten that a fortieth does not exceed. */
  @ParameterizedTest
  @CsvSource({
    "40, 1",
    "41, 2",
    "80, 2",
    "81, 2.5",
    "100, 2.5",
    "101, 5",
    "200, 5",
    "201, 10",
    "400, 10",
    "401, 20",
    "4, 0.1",
    "4.1, 0.2",
    "0.3, 0.01"
  })
  void widths_areRound(double span, double width) {
    for (double from : new double[] {0, -100}) {
      Axis axis = numbered(from, from + span);
      assertEquals(new Interval(from, from + width), ends(axis, 0, 1));
    }
  }

  @Test
  void oneNumber_hasOneBin() {
    Axis axis = numbered(7.3, 7.3);
    assertEquals(1, axis.count());
    assertEquals(List.of(0, 0), bins(axis, 2));
    assertEquals(new Interval(7, 8), ends(axis, 0, 1));
    assertEquals(0, numbered().count());
  }

  @Test
  void width_isAsGiven() {
    double[] values = {0, 4.9, 5, 359.9};
    Axis axis = Axis.numbered("bearing_deg", 4, 5, i -> values[i]);
    assertEquals(List.of(0, 0, 1, 71), bins(axis, 4));
    assertEquals(72, axis.count());
    assertEquals(new Interval(5, 360), ends(axis, 1, 72));
    assertThrows(IllegalArgumentException.class, () -> Axis.numbered("d", 1, 0, i -> 1));
  }

  /** Three times a tenth is not three tenths in binary fractions; a reader is told 0.3. */
  @Test
  void borders_haveNoLastDigits() {
    Axis axis = Axis.numbered("d", 1, 0.1, i -> 0.65);
    assertEquals(new Interval(0.3, 0.7), ends(axis, 3, 7));
  }
}
