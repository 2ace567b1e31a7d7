package simbad.experiments.batch;

import java.util.SplittableRandom;

/**
 * An order of the numbers in [0, size) by chance, of which any part can be had without the rest.
 *
 * <p>A Feistel network permutes the next larger power of four (Luby and Rackoff, 1988); what it
 * sends beyond the size it is asked again, until it is inside (Black and Rogaway, 2002). So the
 * first so many numbers are a sample without repeats.
 */
final class Permutation {
  /** Of a greater one the power of four would not fit 64 bits. */
  static final long GREATEST_SIZE = 1L << 62;

  private static final int ROUNDS = 8;

  private final long size;
  private final int halfBits;
  private final long[] keys;

  /**
   * An order.
   *
   * @param size in [1, {@value #GREATEST_SIZE}]
   * @param seed of chance
   */
  Permutation(long size, long seed) {
    this.size = size;
    int bits = Long.SIZE - Long.numberOfLeadingZeros(size - 1);
    halfBits = Math.max(1, (bits + 1) / 2);
    keys = new SplittableRandom(seed).longs(ROUNDS).toArray();
  }

  /** The number at a place; both in [0, size). */
  long at(long place) {
    long number = place;
    do {
      number = shuffled(number);
    } while (number >= size);
    return number;
  }

  private long shuffled(long number) {
    long mask = (1L << halfBits) - 1;
    long left = number >>> halfBits;
    long right = number & mask;
    for (long key : keys) {
      long next = left ^ (mixed(right + key) & mask);
      left = right;
      right = next;
    }
    return left << halfBits | right;
  }

  /** Stafford's variant 13, the mixing function of {@link SplittableRandom}. */
  private static long mixed(long value) {
    long mixed = value;
    mixed = (mixed ^ (mixed >>> 30)) * 0xbf58476d1ce4e5b9L;
    mixed = (mixed ^ (mixed >>> 27)) * 0x94d049bb133111ebL;
    return mixed ^ (mixed >>> 31);
  }
}
