package simbad.bench.capture;

import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Which pings of a journal count no longer: those of a distance that was undone, those of a bearing
 * that was repeated. A bit for each ping. Not thread-safe.
 */
final class VoidPings {
  private final SweepState state = new SweepState();
  private final Map<Integer, Integer> counts = new HashMap<>();
  private final Map<Integer, BitSet> voided = new HashMap<>();

  /** Takes the next entry. */
  void take(Entry entry) {
    if (entry instanceof Entry.Taken taken) {
      counts.merge(taken.bearing(), 1, Integer::sum);
    } else if (entry instanceof Entry.Undone undone) {
      List<Level> levels = state.levels(undone.bearing());
      if (!levels.isEmpty()) {
        forgetLast(undone.bearing(), levels.get(levels.size() - 1).pings());
      }
    } else if (entry instanceof Entry.Repeated repeated) {
      bits(repeated.bearing()).set(0, counts.getOrDefault(repeated.bearing(), 0));
    }
    state.take(entry);
  }

  private void forgetLast(int bearing, int pings) {
    BitSet bits = bits(bearing);
    int at = counts.getOrDefault(bearing, 0);
    for (int left = pings; left > 0; left--) {
      at = bits.previousClearBit(at - 1);
      bits.set(at);
    }
  }

  private BitSet bits(int bearing) {
    return voided.computeIfAbsent(bearing, unused -> new BitSet());
  }

  /** Returns the state after the entries. */
  SweepState state() {
    return state;
  }

  /**
   * Tells whether a ping counts.
   *
   * @param bearing index in the plan
   * @param number of the ping among those of its bearing, from 0
   */
  boolean counts(int bearing, int number) {
    return !voided.containsKey(bearing) || !bits(bearing).get(number);
  }
}
