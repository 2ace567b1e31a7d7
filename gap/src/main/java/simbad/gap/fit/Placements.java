package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BinaryOperator;
import simbad.sonar.ping.PingLog;

/**
 * Readings that were taken without anything being moved: those of one word in the column placement,
 * else those of one run at equal poses. They share what their pose is off by, so that a hundred of
 * them say of a tape no more than one does.
 */
public final class Placements {
  /** What a tape or a ruler may be off by, metres; placement-error is searched as far. */
  public static final double MOST_OFF_M = 0.05;

  /** Readings of a placement, in the mean, from which on a log is one of things put in place. */
  private static final int READ_AGAIN = 2;

  /** With fewer, half of them show nothing of the other half. */
  private static final int LEAST = 4;

  private static final Comparator<Spot> BY_PLACE =
      Comparator.comparingDouble(Spot::xM)
          .thenComparingDouble(Spot::zM)
          .thenComparingDouble(Spot::headingRad)
          .thenComparing(Spot::label);

  private final int[] placement;
  private final int count;
  private final boolean said;

  /** Where a sensor stood and how it looked, in a run or a placement of some name. */
  private record Spot(double xM, double zM, double headingRad, String label) {
    static Spot of(PingLog log, int ping, String label) {
      return new Spot(log.xM(ping), log.zM(ping), log.headingRad(ping), label);
    }
  }

  /** Finds the placements of a log; they are numbered by their poses, whatever the rows' order. */
  public Placements(PingLog log) {
    Map<Object, List<Integer>> pings = new HashMap<>();
    Map<Object, Spot> spots = new HashMap<>();
    boolean words = false;
    boolean untimed = false;
    for (int i = 0; i < log.size(); i++) {
      Optional<String> word = log.placement(i);
      Spot spot = Spot.of(log, i, word.orElse(log.runs().get(log.run(i))));
      Object key = word.isPresent() ? word.get() : spot;
      pings.computeIfAbsent(key, one -> new ArrayList<>()).add(i);
      spots.merge(key, spot, BinaryOperator.minBy(BY_PLACE));
      words |= word.isPresent();
      untimed |= !log.isTimed(i);
    }
    said = words || untimed;
    placement = new int[log.size()];
    count = pings.size();
    int number = 0;
    for (Map.Entry<Object, Spot> at :
        spots.entrySet().stream().sorted(Map.Entry.comparingByValue(BY_PLACE)).toList()) {
      for (int ping : pings.getOrDefault(at.getKey(), List.of())) {
        placement[ping] = number;
      }
      number++;
    }
  }

  /** Returns the number of placements. */
  public int count() {
    return count;
  }

  /** Returns the pings of each placement, in the order of its number. */
  public List<int[]> pings() {
    int[] size = new int[count];
    Arrays.stream(placement).forEach(at -> size[at]++);
    List<int[]> pings = Arrays.stream(size).mapToObj(int[]::new).toList();
    for (int ping = placement.length - 1; ping >= 0; ping--) {
      pings.get(placement[ping])[--size[placement[ping]]] = ping;
    }
    return pings;
  }

  /** Returns the placement of a ping, from 0 on. */
  public int of(int ping) {
    return placement[ping];
  }

  /**
   * Tells whether things were put in place and read there: the log says so, or has no times, or has
   * several readings to a place. A sensor that is moved along never stands where it stood.
   */
  public boolean areRepeated() {
    return count >= LEAST && (said || placement.length >= READ_AGAIN * count);
  }
}
