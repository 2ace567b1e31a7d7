package simbad.motion;

/**
 * What the simulator believes of a robot.
 *
 * @param differential whether commands are those of two wheels
 * @param wheelBaseM between the wheels, 0 where it is not differential
 * @param separateClocks whether commands and track were timed by different clocks
 * @param trackSigmaM of the tracker's x and y
 * @param trackSigmaRad of its heading
 * @param motion what is believed of the motion beyond the exact one
 */
public record Robot(
    boolean differential,
    double wheelBaseM,
    boolean separateClocks,
    double trackSigmaM,
    double trackSigmaRad,
    MotionChain motion) {
  /** A body that does exactly what it is told, tracked exactly. */
  public static final Robot EXACT_UNICYCLE = new Robot(false, 0, false, 0, 0, MotionChain.EXACT);

  /** Checks the figures. */
  public Robot {
    if (!(trackSigmaM >= 0 && trackSigmaRad >= 0)) {
      throw new IllegalArgumentException(
          "track sigma = " + trackSigmaM + " m, " + trackSigmaRad + " rad is not at least 0");
    }
    if (!(wheelBaseM > 0 || (!differential && wheelBaseM == 0))) {
      throw new IllegalArgumentException("wheelBaseM = " + wheelBaseM + " does not fit the drive");
    }
  }
}
