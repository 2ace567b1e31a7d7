package simbad.bench.capture;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * How far a sweep has come: what was heard at each distance of each bearing, and which bearings are
 * done. Made of a journal's entries, one by one. Not thread-safe.
 */
public final class SweepState {
  private final Map<Integer, List<Level>> levels = new TreeMap<>();
  private final Set<Integer> done = new TreeSet<>();
  private long pings;
  private OptionalDouble temperatureC = OptionalDouble.empty();

  /** Takes the next entry. */
  public void take(Entry entry) {
    if (entry instanceof Entry.Taken taken) {
      pings++;
      temperatureC = taken.temperatureC();
      add(taken);
    } else if (entry instanceof Entry.Done finished) {
      done.add(finished.bearing());
    } else if (entry instanceof Entry.Undone undone) {
      done.remove(undone.bearing());
      List<Level> known = mutable(undone.bearing());
      if (!known.isEmpty()) {
        known.remove(known.size() - 1);
      }
    } else if (entry instanceof Entry.Repeated repeated) {
      done.remove(repeated.bearing());
      mutable(repeated.bearing()).clear();
    }
  }

  private void add(Entry.Taken taken) {
    List<Level> known = mutable(taken.bearing());
    int last = known.size() - 1;
    TriedDistance probe = taken.probe();
    if (last >= 0 && known.get(last).isAt(probe.distanceM(), probe.approach())) {
      known.set(last, known.get(last).with(taken.isHeard()));
    } else {
      known.add(new Level(probe.distanceM(), probe.approach(), 0, 0).with(taken.isHeard()));
    }
  }

  private List<Level> mutable(int bearing) {
    return levels.computeIfAbsent(bearing, unused -> new ArrayList<>());
  }

  /** Returns what was heard at a bearing, in the order in which it was taken. */
  public List<Level> levels(int bearing) {
    return List.copyOf(levels.getOrDefault(bearing, List.of()));
  }

  /** Tells whether a bearing is done. */
  public boolean isDone(int bearing) {
    return done.contains(bearing);
  }

  /** Returns how many bearings are done. */
  public int doneCount() {
    return done.size();
  }

  /** Returns how many pings were recorded, those that count no longer included. */
  public long pings() {
    return pings;
  }

  /** Returns how warm the air was at the last ping; empty when it was not known. */
  public OptionalDouble temperatureC() {
    return temperatureC;
  }

  /** Returns the first bearing that is not done; empty when all are. */
  public OptionalInt nextBearing(SweepPlan plan) {
    for (int bearing = 0; bearing < plan.bearings(); bearing++) {
      if (!isDone(bearing)) {
        return OptionalInt.of(bearing);
      }
    }
    return OptionalInt.empty();
  }
}
