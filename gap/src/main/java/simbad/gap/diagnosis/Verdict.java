package simbad.gap.diagnosis;

import java.util.List;

/** What a diagnosis concludes. */
public enum Verdict {
  /** No gap beyond chance. */
  NONE("none"),
  /** The effects named account for the gap. */
  EXPLAINED("explained"),
  /** The effects named are at work, and something else is too. */
  PARTLY("partly"),
  /** A gap is left, or all of it, that no named effect accounts for. */
  UNEXPLAINED("unexplained"),
  /** These data cannot tell. */
  UNDECIDED("undecided");

  /** What may be so. Partly is unexplained as well; undecided is no state of the world. */
  public static final List<Verdict> TRUTHS = List.of(NONE, EXPLAINED, UNEXPLAINED);

  private final String word;

  Verdict(String word) {
    this.word = word;
  }

  /** Returns whether effects are named with it, so that something can be done about them. */
  public boolean namesEffects() {
    return this == EXPLAINED || this == PARTLY;
  }

  /** Returns the word as it stands in files. */
  public String word() {
    return word;
  }
}
