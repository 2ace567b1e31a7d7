package simbad.gap.locate;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import simbad.gap.slice.Axis;
import simbad.gap.slice.Slice;

/**
 * Looks for the slice that holds the most of an excess in the fewest pings: of all slices of a cut
 * the one whose sum squared over its number of pings is greatest, which is twice the log likelihood
 * that a mean of its own gains where scatter is even.
 */
final class Scan {
  private static final int LEAST_ROWS = 15;

  /** A second variable has to gain this much, or the place is easier to read without it. */
  private static final double WORTH = 1.25;

  /** A name is easier to read than an interval that hardly holds more. */
  private static final double NAMED = 1.1;

  private static final int ROUNDS = 3;

  private final double[] excess;
  private final IntPredicate counts;

  /**
   * Creates a scan.
   *
   * @param excess of each ping
   * @param counts tells which pings are looked at
   */
  Scan(double[] excess, IntPredicate counts) {
    this.excess = excess;
    this.counts = counts;
  }

  /**
   * Slices that are looked at together.
   *
   * @param within which they lie
   * @param axes one or two that they are cut by
   */
  record Cut(Slice within, List<Axis> axes) {
    Cut {
      axes = List.copyOf(axes);
    }
  }

  /**
   * A slice that was found.
   *
   * @param slice itself
   * @param merit sum of its excess squared, over its number of pings; a little more for names
   */
  record Found(Slice slice, double merit) {}

  /** Finds the best slice of a cut; empty where no slice has enough pings and an excess. */
  Optional<Found> best(Cut cut) {
    Axis first = cut.axes().get(0);
    Optional<Found> alone = best(cut.within(), first);
    if (cut.axes().size() == 1) {
      return alone;
    }
    Axis second = cut.axes().get(1);
    Optional<Found> other = best(cut.within(), second);
    double merit = Math.max(merit(alone), merit(other));
    return better(alternated(cut, first, second), alternated(cut, second, first))
        .filter(found -> found.merit() > WORTH * merit);
  }

  private static double merit(Optional<Found> found) {
    return found.map(Found::merit).orElse(0.0);
  }

  private static Optional<Found> better(Optional<Found> one, Optional<Found> other) {
    return merit(other) > merit(one) ? other : one;
  }

  /** Each variable in turn, within the best interval of the other. */
  private Optional<Found> alternated(Cut cut, Axis first, Axis second) {
    Optional<Found> best = best(cut.within(), first);
    for (int round = 0; round < ROUNDS && best.isPresent(); round++) {
      best = best(within(cut, best.get()), second);
      if (best.isPresent()) {
        best = best(within(cut, best.get()), first);
      }
    }
    return best;
  }

  private static Slice within(Cut cut, Found found) {
    List<Slice.Range> ranges = found.slice().ranges();
    return cut.within().and(ranges.get(ranges.size() - 1));
  }

  private Optional<Found> best(Slice within, Axis axis) {
    double[] sum = new double[axis.count() + 1];
    int[] rows = new int[axis.count() + 1];
    boolean[] isEmpty = new boolean[axis.count()];
    Arrays.fill(isEmpty, true);
    for (int ping = 0; ping < excess.length; ping++) {
      int bin = axis.bin(ping);
      if (bin >= 0 && within.holds(ping)) {
        isEmpty[bin] = false;
        sum[bin + 1] += counts.test(ping) ? excess[ping] : 0;
        rows[bin + 1] += counts.test(ping) ? 1 : 0;
      }
    }
    for (int bin = 0; bin < axis.count(); bin++) {
      sum[bin + 1] += sum[bin];
      rows[bin + 1] += rows[bin];
    }
    return best(within, axis, sum, rows, isEmpty);
  }

  /** Of all intervals that begin where there are pings, or all names, by sums up to each bin. */
  private static Optional<Found> best(
      Slice within, Axis axis, double[] sum, int[] rows, boolean[] isEmpty) {
    Optional<Found> best = Optional.empty();
    for (int from = 0; from < axis.count(); from++) {
      int last = isEmpty[from] ? from : axis.ordered() ? axis.count() : from + 1;
      for (int to = from + 1; to <= last; to++) {
        int count = rows[to] - rows[from];
        double total = sum[to] - sum[from];
        if (count >= LEAST_ROWS && total > 0) {
          double merit = (axis.ordered() ? 1 : NAMED) * total * total / count;
          if (merit > merit(best)) {
            best = Optional.of(new Found(within.and(new Slice.Range(axis, from, to)), merit));
          }
        }
      }
    }
    return best;
  }
}
