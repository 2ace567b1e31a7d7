package simbad.blindworld.score;

import java.util.List;
import java.util.Locale;

/** What a diagnosis concludes. */
public enum Verdict {
  /** No gap beyond chance. */
  NONE,
  /** The named effects account for the gap. */
  EXPLAINED,
  /** A gap is left that no named effect accounts for. */
  UNEXPLAINED,
  /** The named effects are at work, and something else is too. */
  PARTLY,
  /** The data cannot tell: cautious whatever the truth is, and never right. */
  UNDECIDED;

  /** What a world can be: those that a diagnosis may state a probability of. */
  static final List<Verdict> TRUTHS = List.of(NONE, EXPLAINED, UNEXPLAINED);

  /** As files spell it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
