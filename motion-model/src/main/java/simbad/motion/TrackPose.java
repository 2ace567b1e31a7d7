package simbad.motion;

/**
 * Where a robot was, in a frame with y up the page: z of the files is -y here.
 *
 * @param timeS when, seconds
 * @param xM to the right
 * @param yM up the page
 * @param headingRad counter-clockwise from x; any turn
 */
public record TrackPose(double timeS, double xM, double yM, double headingRad) {
  /** Checks that all are finite. */
  public TrackPose {
    if (!Double.isFinite(timeS + xM + yM + headingRad)) {
      throw new IllegalArgumentException(
          "pose = (" + timeS + ", " + xM + ", " + yM + ", " + headingRad + ") is not finite");
    }
  }
}
