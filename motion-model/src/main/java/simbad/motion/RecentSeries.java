package simbad.motion;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.function.BiConsumer;

/**
 * The series of what was asked for last: the one that was not asked for longest makes room.
 *
 * @param <K> what a series comes from
 */
final class RecentSeries<K> {
  private static final int KEPT = 3;

  private final int size;
  private final BiConsumer<K, CommandSeries> fill;
  private final Deque<Entry<K>> entries = new ArrayDeque<>();

  private record Entry<K>(K key, CommandSeries series) {}

  /**
   * Prepares series.
   *
   * @param size of each
   * @param fill computes a series from its key
   */
  RecentSeries(int size, BiConsumer<K, CommandSeries> fill) {
    this.size = size;
    this.fill = fill;
  }

  /** Returns the series of a key, which is as it was until other keys have been asked for. */
  CommandSeries of(K key) {
    Entry<K> entry = taken(key);
    entries.addFirst(entry);
    return entry.series;
  }

  private Entry<K> taken(K key) {
    for (Iterator<Entry<K>> each = entries.iterator(); each.hasNext(); ) {
      Entry<K> entry = each.next();
      if (entry.key.equals(key)) {
        each.remove();
        return entry;
      }
    }
    CommandSeries series =
        entries.size() < KEPT
            ? new CommandSeries(new double[size], new double[size])
            : entries.removeLast().series;
    fill.accept(key, series);
    return new Entry<>(key, series);
  }
}
