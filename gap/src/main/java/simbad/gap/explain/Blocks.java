package simbad.gap.explain;

import java.util.Comparator;
import java.util.HashMap;
import java.util.Map;
import java.util.stream.IntStream;
import simbad.gap.fit.Fold;
import simbad.sonar.effect.PingLog;

/**
 * A log cut into blocks of time that belong together: neighbouring pings share what is not
 * modelled, so what was fitted on one is no test on the other.
 */
public final class Blocks {
  private static final int PER_RUN = 12;

  /** Rows of a block at least, where a run has enough of them for two. */
  public static final int LEAST_ROWS = 25;

  private final int[] block;
  private final int count;

  /**
   * Cuts each run into up to 12 pieces of equal time, all sensors together. Where rows have no
   * time, what stands at one place stays together and the places are dealt to the pieces.
   */
  public Blocks(PingLog log) {
    int size = log.size();
    double[] end = new double[log.runs().size()];
    int[] rows = new int[end.length];
    for (int i = 0; i < size; i++) {
      end[log.run(i)] = Math.max(end[log.run(i)], log.timeS(i) - log.runStartS(i));
      rows[log.run(i)]++;
    }
    Map<Place, Integer> places = timeless(log);
    block = new int[size];
    Map<Long, Integer> numbers = new HashMap<>();
    for (int i = 0; i < size; i++) {
      int run = log.run(i);
      int pieces = Math.max(1, Math.min(PER_RUN, rows[run] / LEAST_ROWS));
      double share = end[run] > 0 ? (log.timeS(i) - log.runStartS(i)) / end[run] : 0;
      int inTime = (int) Math.min(pieces - 1, Math.floor(share * pieces));
      int place = places.getOrDefault(Place.of(log, i), 0);
      int piece = log.isTimed(i) ? inTime : place % pieces;
      block[i] = numbers.computeIfAbsent((long) run * PER_RUN + piece, key -> numbers.size());
    }
    count = numbers.size();
  }

  /** Where a sensor was. */
  private record Place(double xM, double zM, double headingRad) {
    static Place of(PingLog log, int ping) {
      return new Place(log.xM(ping), log.zM(ping), log.headingRad(ping));
    }
  }

  /** Numbers the places in an order that is not that of the rows. */
  private static Map<Place, Integer> timeless(PingLog log) {
    Map<Place, Integer> numbers = new HashMap<>();
    IntStream.range(0, log.size())
        .filter(ping -> !log.isTimed(ping))
        .mapToObj(ping -> Place.of(log, ping))
        .distinct()
        .sorted(
            Comparator.comparingDouble(Place::xM)
                .thenComparingDouble(Place::zM)
                .thenComparingDouble(Place::headingRad))
        .forEach(place -> numbers.put(place, numbers.size()));
    return numbers;
  }

  /** Returns the number of blocks. */
  public int count() {
    return count;
  }

  /** Tells whether values can be fitted on one part and tested on another, both of enough rows. */
  public boolean canBeHeldOut() {
    return count > 1 && block.length >= 2 * LEAST_ROWS;
  }

  /** Returns the block of a ping. */
  public int of(int ping) {
    return block[ping];
  }

  /** Returns every other block, from the first or the second on. */
  public Fold half(int first) {
    return part(first, 2);
  }

  /**
   * Returns every so manieth block.
   *
   * @param first from 0 on
   * @param parts that the blocks are dealt to
   */
  public Fold part(int first, int parts) {
    return ping -> block[ping] % parts == first;
  }
}
