package simbad.demo;

import simbad.sim.Agent;
import simbad.sim.RangeSensorBelt;

/**
 * Drives a robot on and keeps it clear of what its belt sees: it slows down, turns to the side
 * where there is more room, and backs off where it has run into something all the same.
 *
 * <p>Once it turns it keeps the side until the way is free, so that a corner does not hold it.
 */
final class Avoidance {
  private static final double TURN_RAD_PER_S = 1.5;
  private static final double SWERVE_RAD_PER_S = 0.8;
  private static final double FRONT_RAD = Math.PI / 3;

  /** Nearness, from 0 at the belt's range to 1 at the rim, at which the way counts as blocked. */
  private static final double BLOCKED = 0.55;

  private static final double FREE = 0.4;
  private static final int BACK_STEPS = 15;

  private final Agent robot;
  private final RangeSensorBelt belt;
  private final double speedMPerS;
  private int side;
  private int backSteps;
  private double left;
  private double right;
  private double ahead;

  Avoidance(Agent robot, RangeSensorBelt belt, double speedMPerS) {
    this.robot = robot;
    this.belt = belt;
    this.speedMPerS = speedMPerS;
  }

  /** Sets the robot's velocities for this step. */
  void steer() {
    look();
    if (robot.collisionDetected()) {
      backSteps = BACK_STEPS;
    }
    if (backSteps > 0) {
      backSteps--;
      robot.setTranslationalVelocity(-speedMPerS / 2);
      robot.setRotationalVelocity(chosenSide() * SWERVE_RAD_PER_S);
    } else if (ahead > (side == 0 ? BLOCKED : FREE)) {
      robot.setTranslationalVelocity(0);
      robot.setRotationalVelocity(chosenSide() * TURN_RAD_PER_S);
    } else {
      side = 0;
      robot.setTranslationalVelocity(speedMPerS * (1 - ahead));
      robot.setRotationalVelocity((right - left) * SWERVE_RAD_PER_S);
    }
  }

  private int chosenSide() {
    if (side == 0) {
      side = right > left ? 1 : -1;
    }
    return side;
  }

  private void look() {
    left = 0;
    right = 0;
    ahead = 0;
    for (int i = 0; i < belt.getNumSensors(); i++) {
      double angleRad = Math.IEEEremainder(belt.getSensorAngle(i), 2 * Math.PI);
      double nearness = belt.hasHit(i) ? 1 - belt.getMeasurement(i) / belt.getMaxRange() : 0;
      if (Math.abs(angleRad) <= FRONT_RAD) {
        ahead = Math.max(ahead, nearness);
      }
      if (angleRad > 0 && angleRad < Math.PI / 2) {
        left = Math.max(left, nearness);
      } else if (angleRad < 0 && angleRad > -Math.PI / 2) {
        right = Math.max(right, nearness);
      }
    }
  }
}
