package simbad.experiments.export;

/**
 * A diagnosed sensor in whole numbers, as the exported C99 header computes it, bit for bit. It
 * remembers the ping before; for one sensor and one thread.
 */
public final class IntegerDiagnosis {
  private static final int HALF_TURN_CDEG = 18_000;

  private final IntegerReader sonar;
  private final DiagnosisFigures figures;
  private int lastMm;
  private int repeats;
  private boolean heard;

  IntegerDiagnosis(IntegerReader sonar, DiagnosisFigures figures) {
    this.sonar = sonar;
    this.figures = figures;
  }

  /** Forgets the pings before. */
  public void reset() {
    lastMm = 0;
    repeats = 0;
    heard = false;
  }

  /**
   * Reads the next ping.
   *
   * @param xMm of the sensor, in the frame of the obstacle where it was believed to stand
   * @param zMm likewise, millimetres
   * @param headingCdeg hundredths of a degree, from -18000 to 18000
   * @return millimetres, or {@link IntegerSonar#NO_ECHO}
   */
  public int readNextMm(int xMm, int zMm, int headingCdeg) {
    int[] place = {xMm, zMm};
    int heading = headingCdeg;
    if (figures.isMoved()) {
      place =
          IntegerSonar.placed(xMm - figures.atXMm(), zMm - figures.atZMm(), figures.turnedCdeg());
      heading = whole(heading - figures.turnedCdeg());
    }
    heading = whole(heading + figures.turnCdeg());
    int mm = sonar.readMm(heard, place[0], place[1], heading);
    heard = mm != IntegerSonar.NO_ECHO || figures.codeMm() >= 0;
    if (heard) {
      lastMm = mm == IntegerSonar.NO_ECHO ? figures.codeMm() : figures.reportedMm(mm);
      repeats = figures.repeats();
      return lastMm;
    }
    return repeats-- > 0 ? lastMm : silent();
  }

  private int silent() {
    repeats = 0;
    return IntegerSonar.NO_ECHO;
  }

  private static int whole(int cdeg) {
    return cdeg < -HALF_TURN_CDEG
        ? cdeg + 2 * HALF_TURN_CDEG
        : cdeg > HALF_TURN_CDEG ? cdeg - 2 * HALF_TURN_CDEG : cdeg;
  }
}
