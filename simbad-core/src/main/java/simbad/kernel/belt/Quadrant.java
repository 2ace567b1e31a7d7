package simbad.kernel.belt;

/**
 * The eight overlapping sides of a belt. Bounds belong to both neighbours; the straight-ahead ray
 * has angle 0 and therefore never counts as front right, as old programs expect.
 */
public enum Quadrant {
  /** From straight ahead to the left. */
  FRONT_LEFT(0, 2),
  /** An eighth of a turn to both sides of the left. */
  LEFT(1, 3),
  /** From the left to straight back. */
  BACK_LEFT(2, 4),
  /** An eighth of a turn to both sides of straight back. */
  BACK(3, 5),
  /** From straight back to the right. */
  BACK_RIGHT(4, 6),
  /** An eighth of a turn to both sides of the right. */
  RIGHT(5, 7),
  /** From the right to straight ahead. */
  FRONT_RIGHT(6, 8),
  /** The left half of the front. */
  FRONT_LEFT_HALF(0, 1),
  /** The right half of the front. */
  FRONT_RIGHT_HALF(7, 8);

  private final double fromRad;
  private final double toRad;

  Quadrant(int fromEighth, int toEighth) {
    fromRad = fromEighth * Math.PI / 4;
    toRad = toEighth * Math.PI / 4;
  }

  /** Returns the least angle in radians, included. */
  public double fromRad() {
    return fromRad;
  }

  /** Returns the greatest angle in radians, included. */
  public double toRad() {
    return toRad;
  }
}
