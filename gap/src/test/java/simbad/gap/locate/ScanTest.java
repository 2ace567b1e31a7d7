package simbad.gap.locate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.slice.Axis;
import simbad.gap.slice.Slice;

/** Four hundred pings, twenty steps of one variable by twenty of another. */
class ScanTest {
  private static final int SIDE = 20;
  private static final Slice ALL = new Slice(List.of());
  private static final Axis ONE = Axis.numbered("one", SIDE * SIDE, 1, i -> Math.floorDiv(i, SIDE));
  private static final Axis OTHER = Axis.numbered("other", SIDE * SIDE, 1, i -> i % SIDE);
  private static final Scan.Cut BOTH = new Scan.Cut(ALL, List.of(ONE, OTHER));

  private static Scan scan(IntPredicate off) {
    double[] excess =
        IntStream.range(0, SIDE * SIDE).mapToDouble(i -> off.test(i) ? 1 : 0).toArray();
    return new Scan(excess, i -> true);
  }

  private static boolean isWithin(int value, int from, int to) {
    return value >= from && value < to;
  }

  @Test
  void range_holdsItsBinsAndNoMore() {
    Slice.Range range = new Slice.Range(ONE, 5, 7);
    for (int ping = 0; ping < SIDE * SIDE; ping++) {
      assertEquals(isWithin(ping / SIDE, 5, 7), range.holds(ping), "ping " + ping);
    }
    assertTrue(ALL.and(range).holds(5 * SIDE));
    assertFalse(ALL.and(range).and(new Slice.Range(OTHER, 3, 4)).holds(5 * SIDE));
  }

  @Test
  void interval_isFoundWithItsBorders() {
    Scan.Found found =
        scan(i -> isWithin(i / SIDE, 5, 7)).best(new Scan.Cut(ALL, List.of(ONE))).orElseThrow();
    assertEquals(List.of(new Slice.Range(ONE, 5, 7)), found.slice().ranges());
    assertEquals(2.0 * SIDE, found.merit(), 1e-9);
  }

  /** Bins that no ping is in are no part of an interval; those in which others count are. */
  @Test
  void interval_beginsWherePingsAre() {
    Axis late = Axis.numbered("late", SIDE * SIDE, 1, i -> 7 + Math.floorDiv(i, SIDE));
    Scan.Cut cut = new Scan.Cut(ALL, List.of(late));
    Scan.Found found = scan(i -> i < 2 * SIDE).best(cut).orElseThrow();
    assertEquals(List.of(new Slice.Range(late, 7, 9)), found.slice().ranges());
    Scan.Found half = scan(i -> i < 2 * SIDE, i -> i >= SIDE).best(cut).orElseThrow();
    assertEquals(List.of(new Slice.Range(late, 7, 9)), half.slice().ranges());
  }

  @Test
  void field_isFoundWithAllItsBorders() {
    Scan.Found found =
        scan(i -> isWithin(i / SIDE, 5, 9) && isWithin(i % SIDE, 3, 10)).best(BOTH).orElseThrow();
    assertTrue(found.slice().ranges().contains(new Slice.Range(ONE, 5, 9)), found::toString);
    assertTrue(found.slice().ranges().contains(new Slice.Range(OTHER, 3, 10)), found::toString);
    assertEquals(28, found.merit(), 1e-9);
  }

  /** What one variable tells alone is told by it alone. */
  @Test
  void secondVariable_hasToBeWorthIt() {
    assertTrue(scan(i -> isWithin(i / SIDE, 5, 9)).best(BOTH).isEmpty());
    // Nine tenths of the other: 18 squared over 18 to a step is less than 1.25 times over 20.
    assertTrue(scan(i -> isWithin(i / SIDE, 5, 9) && i % SIDE < 18).best(BOTH).isEmpty());
    assertTrue(scan(i -> isWithin(i / SIDE, 5, 9) && i % SIDE < 10).best(BOTH).isPresent());
  }

  @Test
  void noExcess_isNowhere() {
    assertTrue(scan(i -> false).best(BOTH).isEmpty());
  }

  /** Fifteen pings are a place, fourteen are none. */
  @Test
  void slice_hasFifteenPings() {
    assertTrue(scan(i -> i < 15, i -> i < 15).best(new Scan.Cut(ALL, List.of(ONE))).isPresent());
    assertTrue(scan(i -> i < 14, i -> i < 14).best(new Scan.Cut(ALL, List.of(ONE))).isEmpty());
  }

  private static Scan scan(IntPredicate off, IntPredicate counts) {
    double[] excess =
        IntStream.range(0, SIDE * SIDE).mapToDouble(i -> off.test(i) ? 1 : 0).toArray();
    return new Scan(excess, counts);
  }

  /** A tenth more for a name, which adjoins no other: 1.1 * 20 * 20 / 20. */
  @Test
  void name_isWorthATenthMore_andStandsAlone() {
    List<String> names = IntStream.range(0, SIDE).mapToObj(i -> "n" + i).toList();
    Axis named = Axis.named("name", SIDE * SIDE, names, i -> i / SIDE);
    Scan.Found found =
        scan(i -> isWithin(i / SIDE, 5, 7)).best(new Scan.Cut(ALL, List.of(named))).orElseThrow();
    assertEquals(List.of(new Slice.Range(named, 5, 6)), found.slice().ranges());
    assertEquals(22, found.merit(), 1e-9);
  }

  /** Within a slice, and of the pings that count, alone. */
  @Test
  void whatIsOutside_isNotLookedAt() {
    Slice within = ALL.and(new Slice.Range(OTHER, 0, 10));
    Scan.Found found =
        scan(i -> i / SIDE == 5, i -> i / SIDE != 5 || i % SIDE != 0)
            .best(new Scan.Cut(within, List.of(ONE)))
            .orElseThrow();
    // Nine pings of ten are too few; with ten of a step beside them 9 squared over 19.
    assertEquals(81 / 19.0, found.merit(), 1e-9);
    Scan.Found two =
        scan(i -> isWithin(i / SIDE, 5, 7)).best(new Scan.Cut(within, List.of(ONE))).orElseThrow();
    assertEquals(
        List.of(new Slice.Range(OTHER, 0, 10), new Slice.Range(ONE, 5, 7)), two.slice().ranges());
    assertEquals(20, two.merit(), 1e-9);
  }

  /** Where pings read less than expected there is no excess, however even. */
  @Test
  void shortfall_isNoExcess() {
    double[] less = IntStream.range(0, SIDE * SIDE).mapToDouble(i -> -1).toArray();
    assertTrue(new Scan(less, i -> true).best(new Scan.Cut(ALL, List.of(ONE))).isEmpty());
  }
}
