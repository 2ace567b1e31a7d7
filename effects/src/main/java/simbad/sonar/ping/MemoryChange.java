package simbad.sonar.ping;

/** What is read depends on what happened in the pings before. */
public non-sealed interface MemoryChange extends Change {
  /** Tells whether it changes nothing: such a change is not asked for anything else. */
  boolean isNeutral();
}
