package simbad.gap.explain;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import simbad.sonar.effect.PingLog;

/**
 * Readings that were taken without anything being moved: those of one run at equal poses. They
 * share what their pose is off by, so that a hundred of them say of a tape no more than one does.
 */
public final class Placements {
  /** Readings of a placement, in the mean, from which on a log is one of things put in place. */
  private static final int READ_AGAIN = 2;

  /** With fewer, half of them show nothing of the other half. */
  private static final int LEAST = 4;

  private final int[] placement;
  private final int count;

  /** Where a sensor stood and how it looked. */
  private record Spot(int run, double xM, double zM, double headingRad) {}

  /** Finds the placements of a log; they are numbered by their poses, whatever the rows' order. */
  public Placements(PingLog log) {
    Map<Spot, List<Integer>> pings = new HashMap<>();
    for (int i = 0; i < log.size(); i++) {
      Spot spot = new Spot(log.run(i), log.xM(i), log.zM(i), log.headingRad(i));
      pings.computeIfAbsent(spot, key -> new ArrayList<>()).add(i);
    }
    List<Spot> spots =
        pings.keySet().stream()
            .sorted(
                Comparator.comparingDouble(Spot::xM)
                    .thenComparingDouble(Spot::zM)
                    .thenComparingDouble(Spot::headingRad)
                    .thenComparing(spot -> log.runs().get(spot.run)))
            .toList();
    placement = new int[log.size()];
    count = spots.size();
    for (int at = 0; at < count; at++) {
      for (int ping : pings.getOrDefault(spots.get(at), List.of())) {
        placement[ping] = at;
      }
    }
  }

  /** Returns the number of placements. */
  public int count() {
    return count;
  }

  /** Returns the placement of a ping, from 0 on. */
  public int of(int ping) {
    return placement[ping];
  }

  /**
   * Tells whether things were put in place and read there, again and again. A sensor that is moved
   * along never stands where it stood.
   */
  public boolean areRepeated() {
    return count >= LEAST && placement.length >= READ_AGAIN * count;
  }
}
