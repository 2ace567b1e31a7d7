package simbad.sonar.ping;

/** Every range is read otherwise than it is. */
public non-sealed interface RangeChange extends Change {
  /**
   * Returns what it does to the ranges of one ping; by default the same as to any other.
   *
   * @param geometry of all pings
   * @param ping index
   */
  default RangeChange at(Geometry geometry, int ping) {
    return this;
  }

  /** Which range changes come first: the way (-1), then scale, offset and scatter (0, 1, 2). */
  int order();

  /**
   * Returns the range that is read on average; by default the range itself.
   *
   * @param rangeM metres
   */
  default double meanM(double rangeM) {
    return rangeM;
  }

  /**
   * Returns the range that is read as another on average: undoes {@link #meanM}, and has to be
   * overridden with it.
   *
   * @param meanM metres
   */
  default double rangeM(double meanM) {
    return meanM;
  }

  /**
   * Returns the standard deviation of the range.
   *
   * @param rangeM metres
   * @param deviationM of the nominal model, or what changes before this one made of it
   */
  default double deviationM(double rangeM, double deviationM) {
    return deviationM;
  }
}
