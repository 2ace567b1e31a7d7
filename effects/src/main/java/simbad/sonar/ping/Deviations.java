package simbad.sonar.ping;

/** Standard deviations of what varies independently. */
public final class Deviations {
  private Deviations() {}

  /**
   * Returns the standard deviation of a sum of two. A root, since hypot takes ten times as long and
   * nothing here is so large or small that squares overflow.
   */
  public static double together(double one, double other) {
    return other == 0 ? Math.abs(one) : Math.sqrt(one * one + other * other);
  }
}
