package simbad.sonar.sensing;

/**
 * Where the transducers of a belt are at the moment of a ping, in the world frame: x to the right,
 * y up, z down the page, metres. A buffer that the belt refills before each ping, so that sensing
 * allocates nothing. Not safe for use by several threads.
 */
public final class TransducerPoses {
  private static final int STRIDE = 6;
  private final double[] values;

  /**
   * Creates a buffer with all transducers at the origin, without direction.
   *
   * @param transducers how many; at least 0
   */
  public TransducerPoses(int transducers) {
    values = new double[transducers * STRIDE];
  }

  /** Returns the number of transducers. */
  public int size() {
    return values.length / STRIDE;
  }

  /**
   * Places a transducer.
   *
   * @param transducer index, from 0
   * @param xM position, metres
   * @param yM height above the floor, metres
   * @param zM position, metres
   */
  public void setPosition(int transducer, double xM, double yM, double zM) {
    int at = transducer * STRIDE;
    values[at] = xM;
    values[at + 1] = yM;
    values[at + 2] = zM;
  }

  /**
   * Points a transducer along a direction of length 1.
   *
   * @param transducer index, from 0
   * @param x component of the direction
   * @param y component of the direction, 0 for a level transducer
   * @param z component of the direction
   */
  public void setDirection(int transducer, double x, double y, double z) {
    int at = transducer * STRIDE + 3;
    values[at] = x;
    values[at + 1] = y;
    values[at + 2] = z;
  }

  /** Returns the x coordinate of a transducer's position in metres. */
  public double xM(int transducer) {
    return values[transducer * STRIDE];
  }

  /** Returns the height of a transducer above the floor in metres. */
  public double yM(int transducer) {
    return values[transducer * STRIDE + 1];
  }

  /** Returns the z coordinate of a transducer's position in metres. */
  public double zM(int transducer) {
    return values[transducer * STRIDE + 2];
  }

  /** Returns the x component of a transducer's direction. */
  public double directionX(int transducer) {
    return values[transducer * STRIDE + 3];
  }

  /** Returns the y component of a transducer's direction. */
  public double directionY(int transducer) {
    return values[transducer * STRIDE + 4];
  }

  /** Returns the z component of a transducer's direction. */
  public double directionZ(int transducer) {
    return values[transducer * STRIDE + 5];
  }

  /**
   * Returns a transducer's heading in radians, counter-clockwise from +x as seen from above, in
   * [-pi, pi]; without meaning for one that looks straight up or down.
   */
  public double headingRad(int transducer) {
    return Math.atan2(-directionZ(transducer), directionX(transducer));
  }
}
