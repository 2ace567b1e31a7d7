package simbad.definition;

/** What the search has to know of an effect beside its forms. */
public enum Trait {
  /** It belongs to the law of the ranges, which is always fitted as a whole. */
  LAW_OF_RANGES,
  /** A plain cause that is tried beside the law of the ranges, even if it gains little alone. */
  BESIDE_THE_LAW,
  /** It takes up a little of anything, since it depends on no place. */
  SOAKS_UP,
  /**
   * Where things are put in place by hand, it takes up what each placement is off by, and has to
   * gain more than others.
   */
  SOAKS_UP_PLACEMENTS,
  /** It is what placements are off by, each by its own amount. */
  MISPLACES,
  /** It takes up what nothing else explains, and is never sure beside such a rest. */
  SOAKS_UP_A_REST,
  /** It makes ranges longer or shorter; at one distance all that do are alike. */
  MOVES_RANGES,
  /**
   * It makes ranges longer or shorter by what is not their length: an echo's level, or the time.
   */
  MOVES_SOME_RANGES,
  /** It puts an obstacle elsewhere: seen from one place, further away is as longer ranges. */
  MOVES_OBSTACLES,
  /** It knows what was read before, and so of readings of one placement what the next one is. */
  KNOWS_THE_PING_BEFORE
}
