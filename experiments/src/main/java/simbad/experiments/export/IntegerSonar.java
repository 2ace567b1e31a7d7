package simbad.experiments.export;

/**
 * The rule of detection shadows in whole numbers, as the exported C99 header computes it: bit for
 * bit the same, in millimetres and hundredths of a degree, without a product of 2^31 or more.
 *
 * <p>Immutable.
 */
public final class IntegerSonar {
  /** What a reading is where nothing is heard. */
  public static final int NO_ECHO = -1;

  /** How far from the obstacle a sensor may be in x and in z, millimetres. */
  public static final int MOST_PLACE_MM = 8191;

  /** A whole turn, hundredths of a degree. */
  private static final int TURN_CDEG = 36_000;

  /** Angles have so many steps in a turn. */
  static final int TURN = 65_536;

  /** Steps of an angle for a hundredth of a degree, times 16384. */
  private static final int STEPS_PER_CDEG = 29_826;

  /** 1 as sines have it. */
  static final int ONE = 16_384;

  private static final int STEPS = 16;
  private static final int HALVES = 2;

  private final int bearings;
  private final int[] thresholdMm;
  private final int[] corner;
  private final int coneSin;
  private final int coneCos;
  private final int leastHalves;
  private final int mostHalves;

  IntegerSonar(HeaderFigures figures) {
    thresholdMm = figures.thresholdMm();
    bearings = thresholdMm.length - 1;
    corner = figures.cornerHalfMm();
    coneSin = figures.coneSin();
    coneCos = figures.coneCos();
    leastHalves = figures.leastHalves();
    mostHalves = figures.mostHalves();
  }

  /** Sine of an angle, 16384 for 1: a polynomial, off by 2 at most. */
  static int sin(int angle) {
    int x = angle & (TURN / 2 - 1);
    x = x > TURN / 4 ? TURN / 2 - x : x;
    int square = scaled(x, x);
    int value = 10_516 - scaled(1173, square);
    value = scaled(25_727 - scaled(value, square), x);
    return (angle & TURN / 2) == 0 ? value : -value;
  }

  static int cos(int angle) {
    return sin(angle + TURN / 4);
  }

  static int angle(int cdeg) {
    return ((cdeg + TURN_CDEG) * STEPS_PER_CDEG) >>> 14;
  }

  private static int scaled(int a, int b) {
    return turned(a, b, 0, 0);
  }

  /** a b + c d over 16384, to the nearest whole number, a half upwards. */
  private static int turned(int a, int b, int c, int d) {
    return Math.floorDiv(a * b + c * d + ONE / 2, ONE);
  }

  /**
   * Reads.
   *
   * @param xMm of the sensor in the obstacle's own frame, millimetres
   * @param zMm of the sensor in the obstacle's own frame, millimetres
   * @param headingCdeg hundredths of a degree, counter-clockwise from +x as seen from above, from
   *     -18000 to 18000
   * @return millimetres, or {@link #NO_ECHO}; nothing is heard beyond {@link #MOST_PLACE_MM}
   */
  public int readMm(int xMm, int zMm, int headingCdeg) {
    return readMm(thresholdMm, xMm, zMm, headingCdeg);
  }

  /** The same by any table of as many thresholds. */
  int readMm(int[] thresholds, int xMm, int zMm, int headingCdeg) {
    if (Math.abs(xMm) > MOST_PLACE_MM
        || Math.abs(zMm) > MOST_PLACE_MM
        || !isInShadow(thresholds, xMm, zMm)) {
      return NO_ECHO;
    }
    int best = nearestSquare(xMm, zMm, headingCdeg);
    int halves = best < 0 ? -1 : (int) Math.sqrt(best);
    return halves < leastHalves || halves > mostHalves ? NO_ECHO : (halves + 1) / HALVES;
  }

  /** The square of the distance to the nearest point in the cone; below 0 for none. */
  private int nearestSquare(int xMm, int zMm, int headingCdeg) {
    int dx = cos(angle(headingCdeg));
    int dz = -sin(angle(headingCdeg));
    int best = -1;
    int[] last = point(0, xMm, zMm, dx, dz);
    for (int i = 1; i < corner.length / 2; i++) {
      int[] here = point(i, xMm, zMm, dx, dz);
      int square = edge(last, here);
      best = square >= 0 && (best < 0 || square < best) ? square : best;
      last = here;
    }
    return best;
  }

  private int[] point(int at, int xMm, int zMm, int dx, int dz) {
    int x = corner[2 * at] - HALVES * xMm;
    int z = corner[2 * at + 1] - HALVES * zMm;
    return new int[] {turned(x, dx, z, dz), turned(x, dz, -z, dx)};
  }

  private int edge(int[] from, int[] to) {
    int[] a = from;
    int[] b = to;
    int[] line = {coneSin, coneCos};
    for (int side = 0; side <= 2; side++) {
      line = side == 2 ? new int[] {b[0] - a[0], b[1] - a[1]} : line;
      if (dot(a, line) < 0) {
        int[] other = a;
        a = b;
        b = other;
      }
      boolean isBeyond = dot(a, line) < 0;
      if (isBeyond && side < 2) {
        return -1;
      }
      if (!isBeyond && dot(b, line) < 0) {
        b = cut(a, b, line);
      }
      line = new int[] {coneSin, -coneCos};
    }
    return Math.min(dot(a, a), dot(b, b));
  }

  static int dot(int[] a, int[] b) {
    return a[0] * b[0] + a[1] * b[1];
  }

  static int[] cut(int[] in, int[] out, int[] line) {
    int[] inside = in;
    int[] outside = out;
    for (int step = 0; step < STEPS; step++) {
      int[] middle = {(inside[0] + outside[0]) / 2, (inside[1] + outside[1]) / 2};
      if (dot(middle, line) >= 0) {
        inside = middle;
      } else {
        outside = middle;
      }
    }
    return inside;
  }

  /** Counts the edges of the shadow that lie beyond a place towards +x. */
  private boolean isInShadow(int[] thresholds, int xMm, int zMm) {
    boolean inside = false;
    int[] last = shadowPoint(thresholds, 0, xMm, zMm);
    for (int i = 1; i <= bearings; i++) {
      int[] here = shadowPoint(thresholds, i, xMm, zMm);
      if (last[1] < 0 != here[1] < 0) {
        int beside = dot(last, new int[] {here[1], -here[0]});
        inside ^= beside < 0 == here[1] < 0;
      }
      last = here;
    }
    return inside;
  }

  private int[] shadowPoint(int[] thresholds, int at, int xMm, int zMm) {
    int threshold = HALVES * thresholds[at];
    int angle = (at * step(bearings) + 128) >> 8;
    return new int[] {
      scaled(threshold, sin(angle)) - HALVES * xMm, scaled(threshold, cos(angle)) - HALVES * zMm
    };
  }

  /** Takes a place from the world's frame to that of an obstacle: x and z. */
  static int[] placed(int xMm, int zMm, int turnCdeg) {
    if (Math.abs(xMm) > MOST_PLACE_MM || Math.abs(zMm) > MOST_PLACE_MM) {
      return new int[] {Short.MAX_VALUE, Short.MAX_VALUE};
    }
    int cos = cos(angle(turnCdeg));
    int sin = sin(angle(turnCdeg));
    return new int[] {turned(xMm, cos, -zMm, sin), turned(zMm, cos, xMm, sin)};
  }

  /** From a bearing of the table to the next, in 256ths of an angle's step. */
  static int step(int bearings) {
    return (256 * TURN + bearings / 2) / bearings;
  }
}
