package simbad.gap.locate;

import java.util.ArrayList;
import java.util.List;
import simbad.gap.diagnosis.Place;

/**
 * Pings that have some things in common.
 *
 * @param ranges all of which hold; none holds every ping
 */
record Slice(List<Range> ranges) {
  /** Copies the list. */
  Slice {
    ranges = List.copyOf(ranges);
  }

  /**
   * Bins that adjoin.
   *
   * @param axis whose bins
   * @param from the first
   * @param to the first beyond
   */
  record Range(Axis axis, int from, int to) {
    boolean holds(int ping) {
      int bin = axis.bin(ping);
      return bin >= from && bin < to;
    }
  }

  boolean holds(int ping) {
    for (Range range : ranges) {
      if (!range.holds(ping)) {
        return false;
      }
    }
    return true;
  }

  Slice and(Range range) {
    List<Range> more = new ArrayList<>(ranges);
    more.add(range);
    return new Slice(more);
  }

  List<Place.Condition> conditions() {
    return ranges.stream().map(range -> range.axis().condition(range.from(), range.to())).toList();
  }
}
