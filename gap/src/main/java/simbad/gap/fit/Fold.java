package simbad.gap.fit;

/** Which pings count: all, or one half of the blocks of a log. */
@FunctionalInterface
public interface Fold {
  /** Every ping counts. */
  Fold ALL = ping -> true;

  /** Returns whether a ping counts. */
  boolean holds(int ping);
}
