package simbad.experiments.control;

/**
 * Walks along the edge on a lattice of equilateral triangles, one step a side, turning on the spot.
 *
 * <p>The triangle between a place that hears, a place that does not and the place ahead of both is
 * left through the side whose ends differ. So the line between heard and unheard places of the
 * lattice is followed without ever missing a turn, however jagged (marching triangles, after Hilton
 * et al., 1996, on the plane). It is slow and ugly, and meant for places where smooth steering is
 * caught.
 */
final class TriangleMarch implements Steering {
  private static final double SAME_SIDE_RAD = Math.PI / 3;
  private static final double OTHER_SIDE_RAD = 2 * Math.PI / 3;

  private final Tuning tuning;
  private boolean heardBefore;
  private double leftToTurnRad;
  private boolean turned;

  TriangleMarch(Tuning tuning, boolean heard) {
    this.tuning = tuning;
    heardBefore = heard;
  }

  @Override
  public void steer(boolean heard, Odometry odometry, Command command) {
    if (!turned) {
      leftToTurnRad = (heard ? -1 : 1) * (heard == heardBefore ? SAME_SIDE_RAD : OTHER_SIDE_RAD);
      heardBefore = heard;
      turned = true;
    }
    if (leftToTurnRad == 0) {
      turned = false;
      command.set(tuning.speedMPerS(), 0);
      return;
    }
    double most = tuning.mostRadPerStep();
    double turnRad = Math.max(-most, Math.min(most, leftToTurnRad));
    leftToTurnRad -= turnRad;
    command.set(0, turnRad / tuning.stepS());
  }
}
