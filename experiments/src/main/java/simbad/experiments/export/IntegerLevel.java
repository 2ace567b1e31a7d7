package simbad.experiments.export;

/**
 * The level model before one obstacle in whole numbers, as the exported C99 header computes it, bit
 * for bit: hundredths of a decibel, millimetres, hundredths of a degree. Immutable.
 */
public final class IntegerLevel implements IntegerReader {
  private static final int[] TANGENTS = {
    8192, 4836, 2555, 1297, 651, 326, 163, 81, 41, 20, 10, 5, 3, 1
  };
  private static final int TURN_MASK = IntegerSonar.TURN - 1;

  private final LevelHeaderFigures figures;

  IntegerLevel(LevelHeaderFigures figures) {
    this.figures = figures;
  }

  /** The angle from (1, 0) to (x, y), 65536 for a turn: the CORDIC algorithm (Volder 1959). */
  static int angleOf(int x, int y) {
    int a = x * 8192;
    int b = y * 8192;
    int angle = 0;
    if (a < 0) {
      a = -a;
      b = -b;
      angle = IntegerSonar.TURN / 2;
    }
    for (int i = 0; i < TANGENTS.length && b != 0; i++) {
      int across = b / (1 << i);
      int along = a / (1 << i);
      int sign = b > 0 ? 1 : -1;
      a += sign * across;
      b -= sign * along;
      angle += sign * TANGENTS[i];
    }
    return angle & TURN_MASK;
  }

  private static int between(int[] table, int index, int rest, int bits) {
    int more = (table[index + 1] - table[index]) * rest;
    return table[index] + ((more + (1 << (bits - 1))) >> bits);
  }

  /**
   * Reads.
   *
   * @param xMm of the sensor in the obstacle's own frame, millimetres
   * @param zMm of the sensor in the obstacle's own frame, millimetres
   * @param headingCdeg hundredths of a degree, counter-clockwise from +x as seen from above, from
   *     -18000 to 18000
   * @return millimetres, or {@link IntegerSonar#NO_ECHO}
   */
  public int readMm(int xMm, int zMm, int headingCdeg) {
    if (Math.abs(xMm) > IntegerSonar.MOST_PLACE_MM || Math.abs(zMm) > IntegerSonar.MOST_PLACE_MM) {
      return IntegerSonar.NO_ECHO;
    }
    int heading = IntegerSonar.angle(headingCdeg);
    int[] nearest = nearest(xMm, zMm, heading);
    int halves = (int) Math.sqrt(IntegerSonar.dot(nearest, nearest));
    if (halves < figures.leastHalves() || halves > figures.mostHalves()) {
      return IntegerSonar.NO_ECHO;
    }
    int excess = excessCdb(xMm, zMm, heading, nearest);
    if (excess < 0) {
      return IntegerSonar.NO_ECHO;
    }
    int cell = Math.min(excess >> 8, figures.walkHalf().length - 2);
    int rest = Math.min(255, excess - cell * 256);
    int range = way(xMm, zMm, halves) + between(figures.walkHalf(), cell, rest, 8);
    return range > 0 ? (range + 1) / 2 : 0;
  }

  /** By the level law an answer does not depend on the ping before. */
  @Override
  public int readMm(boolean heardBefore, int xMm, int zMm, int headingCdeg) {
    return readMm(xMm, zMm, headingCdeg);
  }

  /** What is read of a distance before the walk, halves of a millimetre. */
  private int way(int xMm, int zMm, int halves) {
    if (figures.wayHalf().length == 0) {
      return halves;
    }
    int cells = angleOf(2 * zMm, 2 * xMm) * (figures.wayHalf().length - 1);
    return ((halves * figures.scale() + IntegerSonar.ONE / 2) >> 14)
        + between(figures.wayHalf(), cells >> 16, (cells >> 8) & 255, 8);
  }

  private int excessCdb(int xMm, int zMm, int heading, int[] nearest) {
    int[] at = {2 * xMm, 2 * zMm};
    int away = (int) Math.sqrt(IntegerSonar.dot(at, at));
    int cells = angleOf(at[1], at[0]) * (figures.strengthCdb().length - 1);
    int off = (angleOf(nearest[0], -nearest[1]) - heading) & TURN_MASK;
    off = off >= IntegerSonar.TURN / 2 ? IntegerSonar.TURN - off : off;
    if ((away >> 6) >= figures.lossCdb().length - 1) {
      return -1;
    }
    return between(figures.strengthCdb(), cells >> 16, (cells >> 8) & 255, 8)
        + between(figures.beamCdb(), off >> 7, off & 127, 7)
        - between(figures.lossCdb(), away >> 6, away & 63, 6);
  }

  /** The outline's nearest point as seen from the sensor; of two that nearer the axis. */
  private int[] nearest(int xMm, int zMm, int heading) {
    int[] ahead = {IntegerSonar.cos(heading), -IntegerSonar.sin(heading)};
    int[] corner = figures.cornerHalfMm();
    int[] nearest = {0, 0};
    long best = Long.MAX_VALUE;
    for (int i = 2; i < corner.length; i += 2) {
      int[] foot =
          foot(
              new int[] {corner[i - 2] - 2 * xMm, corner[i - 1] - 2 * zMm},
              new int[] {corner[i] - 2 * xMm, corner[i + 1] - 2 * zMm});
      int square = IntegerSonar.dot(foot, foot);
      boolean isNearer =
          square < best
              || (square == best
                  && IntegerSonar.dot(foot, ahead) > IntegerSonar.dot(nearest, ahead));
      if (isNearer) {
        best = square;
        nearest = foot;
      }
    }
    return nearest;
  }

  private static int[] foot(int[] a, int[] b) {
    int[] line = {b[0] - a[0], b[1] - a[1]};
    if (IntegerSonar.dot(a, line) >= 0) {
      return a;
    }
    return IntegerSonar.dot(b, line) <= 0 ? b : IntegerSonar.cut(b, a, line);
  }
}
