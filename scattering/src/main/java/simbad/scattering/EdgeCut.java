package simbad.scattering;

/**
 * How a straight edge is cut into elements: all as long as {@code elementM}, but shorter within
 * {@value #CORNER_ZONE_M} m of a sharp corner, where the pressure bends like a root of the
 * distance.
 *
 * <p>Lengths there grow in proportion to the distance from the corner. Where the n-th element
 * begins is a smooth function of n, and is asked between whole numbers too: half-way by number, not
 * by length, is where an element's equation holds ({@link Boundary#collocationX}).
 *
 * @param lengthM of the edge, metres, positive
 * @param elementM the greatest length of an element, metres, positive
 * @param sharpBegin whether the body turns sharply where the edge begins
 * @param sharpEnd whether it does where the edge ends
 */
record EdgeCut(double lengthM, double elementM, boolean sharpBegin, boolean sharpEnd) {
  /** A seventeenth of the wavelength in a room at 40 kHz. */
  private static final double CORNER_ZONE_M = 0.5e-3;

  /** At a sharp corner elements are this share of the greatest. */
  private static final double CORNER_SHARE = 0.02;

  /** Returns the number of elements, at least 1. */
  int count() {
    return Math.max(1, (int) Math.ceil(half(sharpBegin) + half(sharpEnd)));
  }

  /**
   * Returns how far from the edge's begin an element begins.
   *
   * @param number of elements before it, in [0, count]; need not be whole
   * @return metres
   */
  double atM(double number) {
    double begin = half(sharpBegin);
    double end = half(sharpEnd);
    double passed = number / count() * (begin + end);
    return passed <= begin
        ? distanceM(passed, sharpBegin)
        : lengthM - distanceM(begin + end - passed, sharpEnd);
  }

  /** Elements, not whole, between an end and the middle of the edge. */
  private double half(boolean sharp) {
    double halfM = lengthM / 2;
    double zoneM = zoneM(sharp);
    return zoneElements(zoneM) + (halfM - zoneM) / elementM;
  }

  private double zoneM(boolean sharp) {
    return sharp ? Math.min(lengthM / 2, CORNER_ZONE_M) : 0;
  }

  /** Length of an element over distance from the corner. */
  private double growth() {
    return (1 - CORNER_SHARE) * elementM / CORNER_ZONE_M;
  }

  private double zoneElements(double zoneM) {
    return Math.log1p(growth() * zoneM / (CORNER_SHARE * elementM)) / growth();
  }

  /** The inverse of half, from the same end. */
  private double distanceM(double elements, boolean sharp) {
    double zoneM = zoneM(sharp);
    double inZone = zoneElements(zoneM);
    return elements < inZone
        ? CORNER_SHARE * elementM * Math.expm1(growth() * elements) / growth()
        : zoneM + (elements - inZone) * elementM;
  }
}
