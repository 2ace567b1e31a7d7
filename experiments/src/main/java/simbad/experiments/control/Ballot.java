package simbad.experiments.control;

/** Readings at one place, of which the more frequent answer counts. */
final class Ballot {
  private final int lead;
  private final int most;
  private int heard;
  private int unheard;

  /**
   * An empty ballot.
   *
   * @param lead by so many readings one answer must lead to end it, at least 1
   * @param most readings, odd
   */
  Ballot(int lead, int most) {
    this.lead = lead;
    this.most = most;
  }

  void add(boolean isHeard) {
    if (isHeard) {
      heard++;
    } else {
      unheard++;
    }
  }

  boolean isDecided() {
    return Math.abs(heard - unheard) >= lead || heard + unheard >= most;
  }

  /** Returns what more readings said, and begins anew. */
  boolean close() {
    boolean more = heard > unheard;
    heard = 0;
    unheard = 0;
    return more;
  }
}
