package simbad.experiments.export;

/** What a header reads of a pose in whole numbers. */
@FunctionalInterface
interface IntegerReader {
  /**
   * Reads.
   *
   * @param heardBefore whether the ping before was answered
   * @param xMm of the sensor in the obstacle's own frame, millimetres
   * @param zMm likewise
   * @param headingCdeg hundredths of a degree, from -18000 to 18000
   * @return millimetres, or {@link IntegerSonar#NO_ECHO}
   */
  int readMm(boolean heardBefore, int xMm, int zMm, int headingCdeg);
}
