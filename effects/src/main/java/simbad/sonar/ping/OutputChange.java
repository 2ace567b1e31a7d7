package simbad.sonar.ping;

/** The sensor reports a range otherwise than it was measured; a greater one never as a lesser. */
public non-sealed interface OutputChange extends Change {
  /** Which output changes come first: the clamp, then the rounding. */
  int order();

  /** Returns what is reported for a measured range, both in metres. */
  double reported(double rangeM);

  /**
   * Returns the least range whose report is not below a value.
   *
   * @param reportedM metres
   * @return metres; negative infinity where every report is above it
   */
  double leastRange(double reportedM);
}
