package simbad.blindworld.score;

import java.util.Locale;

/** What a diagnosis concludes. */
public enum Verdict {
  /** No gap beyond chance. */
  NONE,
  /** The named effects account for the gap. */
  EXPLAINED,
  /** A gap is left that no named effect accounts for. */
  UNEXPLAINED;

  /** As files spell it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
