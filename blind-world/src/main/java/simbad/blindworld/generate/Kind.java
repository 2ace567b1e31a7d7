package simbad.blindworld.generate;

/** What a case asks. */
public enum Kind {
  /** Nothing differs. */
  NONE,
  /** One effect of the vocabulary. */
  SINGLE,
  /** Two effects of the vocabulary. */
  PAIR,
  /** Something outside the vocabulary, alone or beside an effect of it. */
  UNKNOWN,
  /** One effect of the vocabulary that the diagnosis is not told of. */
  WITHHELD,
  /** Three effects of the vocabulary. */
  TRIPLE
}
