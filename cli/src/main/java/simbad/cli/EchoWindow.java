package simbad.cli;

import java.util.ArrayDeque;
import java.util.Deque;

/** The last pings: whether the echo is lost among them, by the rule that holds for the sweep. */
final class EchoWindow {
  private static final int MOST = 20;

  private final int size;
  private final int misses;
  private final Deque<Boolean> last = new ArrayDeque<>();

  /** Of so many pings, lost from so many misses on; a long series is looked at in its last 20. */
  EchoWindow(int pings, int misses) {
    size = Math.min(pings, MOST);
    this.misses = Math.max(1, Math.round((float) misses * size / pings));
  }

  /** Takes a ping; tells whether the echo is lost with it and was not before. */
  boolean losesWith(boolean heard) {
    boolean before = isLost();
    last.add(heard);
    if (last.size() > size) {
      last.remove();
    }
    return isLost() && !before;
  }

  boolean isLost() {
    return last.size() - heard() >= misses;
  }

  private long heard() {
    return last.stream().filter(Boolean::booleanValue).count();
  }

  /** How many were heard, for people. */
  String text() {
    return heard() + " of the last " + last.size() + " heard";
  }
}
