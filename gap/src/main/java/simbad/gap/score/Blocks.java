package simbad.gap.score;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Placements;
import simbad.sonar.ping.PingLog;

/**
 * A log cut into blocks that belong together: neighbouring pings share what is not modelled, so
 * what was fitted on one is no test on the other. Neighbours in time; where things were put in
 * place and read there repeatedly, neighbours in place, whatever the order in which that was done.
 */
public final class Blocks {
  private static final int PER_RUN = 12;

  /** Blocks of a log that was taken place by place, at most. */
  private static final int OF_PLACES = 24;

  /** Rows of a block at least, where a run has enough of them for two. */
  public static final int LEAST_ROWS = 25;

  private final int[] block;
  private final int count;

  /**
   * Cuts a log taken place by place into up to 24 pieces of as many placements, any other one run
   * by run into up to 12 pieces of equal time, all sensors together.
   */
  public Blocks(PingLog log) {
    this(log, new Placements(log));
  }

  private Blocks(PingLog log, Placements placements) {
    block = placements.areRepeated() ? ofPlaces(log, placements) : ofTimes(log);
    count = Arrays.stream(block).max().orElse(-1) + 1;
  }

  private static int[] ofPlaces(PingLog log, Placements placements) {
    int pieces = Math.min(OF_PLACES, placements.count());
    int[] block = new int[log.size()];
    for (int i = 0; i < block.length; i++) {
      block[i] = (int) ((long) placements.of(i) * pieces / placements.count());
    }
    return block;
  }

  private static int[] ofTimes(PingLog log) {
    int size = log.size();
    double[] end = new double[log.runs().size()];
    int[] rows = new int[end.length];
    for (int i = 0; i < size; i++) {
      end[log.run(i)] = Math.max(end[log.run(i)], log.timeS(i) - log.runStartS(i));
      rows[log.run(i)]++;
    }
    int[] block = new int[size];
    Map<Long, Integer> numbers = new HashMap<>();
    for (int i = 0; i < size; i++) {
      int run = log.run(i);
      int pieces = Math.max(1, Math.min(PER_RUN, rows[run] / LEAST_ROWS));
      double share = end[run] > 0 ? (log.timeS(i) - log.runStartS(i)) / end[run] : 0;
      int piece = (int) Math.min(pieces - 1, Math.floor(share * pieces));
      block[i] = numbers.computeIfAbsent((long) run * PER_RUN + piece, key -> numbers.size());
    }
    return block;
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
