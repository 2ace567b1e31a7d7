package simbad.motion;

/**
 * A direction that is turned on by rotations instead of asked anew: a log has tens of thousands of
 * steps, and a search drives it thousands of times.
 */
final class Facing {
  /** Up to it the series of sine and cosine need five terms. */
  private static final double SMALL_RAD = 0.1;

  /** The last of the sine's. */
  private static final double LAST = 1.0 / 362880;

  private double x = 1;
  private double y;
  private double middleX = 1;
  private double middleY;
  private double chord = 1;
  private boolean exact = true;

  /** Faces an angle from the x axis. */
  void face(double rad) {
    x = Math.cos(rad);
    y = Math.sin(rad);
  }

  /** Faces an angle from the x axis that is small, by the series. */
  void faceNear(double rad) {
    if (Math.abs(rad) >= SMALL_RAD) {
      face(rad);
      return;
    }
    double square = rad * rad;
    x = cosine(square);
    y = rad * chord(square);
  }

  /** Turns by an angle; half way, and how long the chord is, can be asked afterwards. */
  void turn(double rad) {
    double half = rad / 2;
    double square = half * half;
    exact = Math.abs(half) < SMALL_RAD;
    chord = exact ? chord(square) : Math.sin(half) / half;
    double sin = half * chord;
    double cos = exact ? cosine(square) : Math.cos(half);
    middleX = x * cos - y * sin;
    middleY = x * sin + y * cos;
    x = middleX * cos - middleY * sin;
    y = middleX * sin + middleY * cos;
  }

  /** Tells whether the last turn was small enough for the series, and as exact as it. */
  boolean isExact() {
    return exact;
  }

  /** Returns the length of the last turn's chord as a share of the arc. */
  double chord() {
    return chord;
  }

  /** Returns the direction half way through the last turn. */
  double middleX() {
    return middleX;
  }

  /** Returns the same along y. */
  double middleY() {
    return middleY;
  }

  /** An angle's sine over the angle, by its square; exact to the last digit or two. */
  private static double chord(double square) {
    return 1 + square * (-1.0 / 6 + square * (1.0 / 120 + square * (-1.0 / 5040 + square * LAST)));
  }

  /** The same of the cosine. */
  private static double cosine(double square) {
    return 1
        + square
            * (-1.0 / 2 + square * (1.0 / 24 + square * (-1.0 / 720 + square * (1.0 / 40320))));
  }
}
