package simbad.experiments.control;

import simbad.sonar.frame.Angles;

/**
 * Weaves along the edge with a small angle, without ever stopping.
 *
 * <p>It keeps an estimate of the edge's direction and steers a fixed angle to the right of it while
 * something is heard, to the left of it while nothing is. The estimate turns to the same side,
 * faster the longer that side lasts: it curls round corners. After most of a half turn the curl
 * ends, for one that only grows tighter could close on itself without meeting the edge again: where
 * something is heard the robot drives straight on, else it circles the last place that heard.
 *
 * <p>A fast robot slows down in bends: while it turns by more than a step can, and where a side
 * lasts longer than a straight edge makes it. Else what it drives would grow with its speed, and a
 * notch of the edge that is smaller than its curves would be cut off.
 */
final class SmoothSteering implements Steering {
  private static final double GREATEST_CURL_RAD = Math.toRadians(135);
  private static final double STEEPEST_RAD = Math.toRadians(60);

  /** On a straight edge a side lasts about so many steps, at any speed. */
  private static final int STRAIGHT_STEPS = 5;

  /** Radius of the circle round the last place that heard, in radii of the tightest turn. */
  private static final double CIRCLE = 1.5;

  private final Tuning tuning;
  private final double circleM;
  private double edgeRad;
  private boolean heardBefore;
  private double turnedRad;
  private int steps;
  private double lastXM;
  private double lastZM;
  private double homeXM;
  private double homeZM;

  /**
   * Begins beside an edge.
   *
   * @param tuning of the robot
   * @param edgeRad direction of the edge, in the sense in which it is followed
   * @param homeXM of a place at which the obstacle was just heard, by the robot's own reckoning
   * @param homeZM likewise
   */
  SmoothSteering(Tuning tuning, double edgeRad, double homeXM, double homeZM) {
    this.tuning = tuning;
    this.edgeRad = edgeRad;
    this.homeXM = homeXM;
    this.homeZM = homeZM;
    circleM = CIRCLE * tuning.bendSpeedMPerS() / tuning.greatestTurnRateRadPerS();
  }

  @Override
  public void steer(boolean heard, Odometry odometry, Command command) {
    double side = heard ? -1 : 1;
    if (heard != heardBefore) {
      cross(side, odometry.headingRad());
    }
    heardBefore = heard;
    lastXM = odometry.xM();
    lastZM = odometry.zM();
    double turnRad =
        turnedRad < GREATEST_CURL_RAD
            ? curled(side) - odometry.headingRad()
            : lost(heard, odometry);
    double most = tuning.mostRadPerStep();
    boolean inBend = Math.abs(turnRad) > most || steps > STRAIGHT_STEPS;
    double speedMPerS = inBend ? tuning.bendSpeedMPerS() : tuning.speedMPerS();
    command.set(speedMPerS, Math.max(-most, Math.min(most, turnRad)) / tuning.stepS());
  }

  /**
   * A straight edge is crossed one way as steeply as the other, so that half of what was turned
   * since the last crossing is the angle to the edge now. Never more than a right angle: the robot
   * has just passed to this side, so it cannot be on its way back.
   */
  private void cross(double side, double headingRad) {
    double steepRad = Math.min(tuning.crossingAngleRad() + turnedRad / 2, Math.PI / 2);
    edgeRad = headingRad + side * steepRad;
    turnedRad = 0;
    steps = 0;
    homeXM = lastXM;
    homeZM = lastZM;
  }

  private double curled(double side) {
    double growth = tuning.curlRadPerStep() * steps;
    double turnRad = Math.min(growth, tuning.mostRadPerStep());
    steps++;
    turnedRad += turnRad;
    edgeRad += side * turnRad;
    return edgeRad + side * tuning.crossingAngleRad();
  }

  /** Straight on leads out of any shadow; back to one leads only the way round its last place. */
  private double lost(boolean heard, Odometry odometry) {
    return heard ? 0 : Angles.signed(roundHomeRad(odometry) - odometry.headingRad());
  }

  private double roundHomeRad(Odometry odometry) {
    double outX = odometry.xM() - homeXM;
    double outZ = odometry.zM() - homeZM;
    double offCircle = (Math.hypot(outX, outZ) - circleM) / circleM;
    double inwardRad = Math.max(-1, Math.min(1, offCircle)) * STEEPEST_RAD;
    return Math.atan2(-outZ, outX) + Math.PI / 2 + inwardRad;
  }
}
