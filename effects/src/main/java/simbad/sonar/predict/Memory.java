package simbad.sonar.predict;

import java.util.List;
import org.jspecify.annotations.Nullable;
import simbad.sonar.change.Burst;
import simbad.sonar.change.GhostReading;
import simbad.sonar.change.Hysteresis;
import simbad.sonar.change.NearerByPrevious;
import simbad.sonar.change.PreviousPing;
import simbad.sonar.change.SecondBounce;
import simbad.sonar.change.StaleReading;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.MemoryChange;

/**
 * The changes of a model that have memory, without those that change nothing.
 *
 * @param burst if pings are missed in bursts
 * @param hysteresis if what is heard depends on whether the ping before was
 * @param stale if readings are repeated
 * @param ghosts whether what is read depends on the reading before
 * @param asRead whether it depends on its number, not on what answered
 */
record Memory(
    @Nullable Burst burst,
    @Nullable Hysteresis hysteresis,
    @Nullable StaleReading stale,
    boolean ghosts,
    boolean asRead) {

  static Memory of(List<? extends Change> changes) {
    boolean asRead =
        Change.only(GhostReading.class, changes).stream().anyMatch(ghost -> ghost.share() > 0)
            || Change.only(NearerByPrevious.class, changes).stream()
                .anyMatch(ghost -> ghost.share() > 0)
            || Change.only(SecondBounce.class, changes).stream()
                .anyMatch(bounce -> bounce.share() > 0);
    return new Memory(
        only(Burst.class, changes),
        only(Hysteresis.class, changes),
        only(StaleReading.class, changes),
        asRead
            || Change.only(PreviousPing.class, changes).stream().anyMatch(ping -> ping.share() > 0),
        asRead);
  }

  private static <T extends MemoryChange> @Nullable T only(
      Class<T> kind, List<? extends Change> changes) {
    List<T> active =
        Change.only(kind, changes).stream().filter(change -> !change.isNeutral()).toList();
    if (active.size() > 1) {
      throw new IllegalArgumentException(
          "changes hold " + active.get(0) + " and " + active.get(1) + "; at most one of a kind");
    }
    return active.isEmpty() ? null : active.get(0);
  }

  boolean isNone() {
    return burst == null && hysteresis == null && stale == null && !ghosts;
  }

  /** Whether all that counts of the pings before can be read off them. */
  boolean isSeen() {
    return burst == null && stale == null;
  }

  /** The share of pings in bursts. */
  double burstShare() {
    return burst == null ? 0 : burst.share();
  }

  /** The share of pings that a state of the burst loses. */
  double lost(int inBurst) {
    return burst == null ? 0 : inBurst * burst.depth();
  }

  /** The chance that a missed ping repeats the last echo; 0 in slot 0, where there is none. */
  double repeats(int slot, double sinceS) {
    return stale == null || slot == 0 ? 0 : stale.holds(slot - HiddenState.ECHO, sinceS);
  }
}
