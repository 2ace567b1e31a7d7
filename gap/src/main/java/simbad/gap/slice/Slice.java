package simbad.gap.slice;

import java.util.ArrayList;
import java.util.List;
import simbad.gap.diagnosis.Place;

/**
 * Pings that have some things in common.
 *
 * @param ranges all of which hold; none holds every ping
 */
public record Slice(List<Range> ranges) {
  /** Copies the list. */
  public Slice {
    ranges = List.copyOf(ranges);
  }

  /**
   * Bins that adjoin.
   *
   * @param axis whose bins
   * @param from the first
   * @param to the first beyond
   */
  public record Range(Axis axis, int from, int to) {
    /** Returns whether a ping lies in these bins. */
    public boolean holds(int ping) {
      int bin = axis.bin(ping);
      return bin >= from && bin < to;
    }
  }

  /** Returns whether a ping is one of them. */
  public boolean holds(int ping) {
    for (Range range : ranges) {
      if (!range.holds(ping)) {
        return false;
      }
    }
    return true;
  }

  /** Returns the pings of these that lie in a range as well. */
  public Slice and(Range range) {
    List<Range> more = new ArrayList<>(ranges);
    more.add(range);
    return new Slice(more);
  }

  /** Says what the pings have in common. */
  public List<Place.Condition> conditions() {
    return ranges.stream().map(range -> range.axis().condition(range.from(), range.to())).toList();
  }
}
