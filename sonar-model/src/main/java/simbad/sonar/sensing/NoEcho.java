package simbad.sonar.sensing;

/** A ping that nothing answered in time. */
public enum NoEcho implements Reading {
  /** The only value: a time-out carries no number. */
  NO_ECHO
}
