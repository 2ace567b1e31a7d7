package simbad.bench.session;

import java.time.Duration;

/** A moment until which something is waited for. */
record Deadline(long endNs) {
  static Deadline in(Duration limit) {
    return new Deadline(System.nanoTime() + limit.toNanos());
  }

  /** The earlier of this one and one that lies so far ahead. */
  Deadline within(Duration limit) {
    Deadline other = in(limit);
    return other.endNs - endNs < 0 ? other : this;
  }

  Duration left() {
    return Duration.ofNanos(Math.max(0, endNs - System.nanoTime()));
  }

  boolean isOver() {
    return left().isZero();
  }
}
