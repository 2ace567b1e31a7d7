package simbad.sonar.ping;

import org.jspecify.annotations.Nullable;

/** One ping and what is known of the ping before it: what was read, or what may have been. */
public final class Moment {
  private final Geometry geometry;
  private int ping;
  private @Nullable Mixture before;

  /** Creates a moment before the first ping. */
  public Moment(Geometry geometry) {
    this.geometry = geometry;
  }

  /**
   * Goes to a ping.
   *
   * @param newPing its index
   * @param newBefore what was read before it; null where nothing was
   */
  public void set(int newPing, @Nullable Mixture newBefore) {
    ping = newPing;
    before = newBefore;
  }

  /** Returns the geometry of all pings. */
  public Geometry geometry() {
    return geometry;
  }

  /** Returns the index of the ping. */
  public int ping() {
    return ping;
  }

  /** Returns the parts of the reading before: one part where it is known, none for a no-echo. */
  public Mixture before() {
    return before == null ? Mixture.EMPTY : before;
  }
}
