package simbad.experiments.control;

import simbad.sonar.sensing.Readings;

/**
 * A robot without a simulator: twelve sonars all round a point that hear a post at (0, 0) while the
 * point lies in a region. Moves as Simbad does: along the heading before the step, then it turns.
 */
final class Course {
  static final double STEP_S = 0.05;

  /** Where the post is heard. */
  @FunctionalInterface
  interface Region {
    boolean contains(double x, double z);
  }

  private final Region region;
  private final Controller controller;
  private final Readings readings = new Readings(12);
  private final Command command = new Command();
  private double x;
  private double z;
  private double headingRad;
  private double woundRad;
  private boolean leftRegion;
  private int steps;

  Course(Region region, Controller controller, double x, double z, double headingRad) {
    this.region = region;
    this.controller = controller;
    this.x = x;
    this.z = z;
    this.headingRad = headingRad;
  }

  double x() {
    return x;
  }

  double z() {
    return z;
  }

  int steps() {
    return steps;
  }

  /** Once it has heard the post and lost it, it is on the edge. */
  boolean isOnEdge() {
    return leftRegion;
  }

  /** Whether it has gone once round since it reached the edge. */
  boolean isRound() {
    return Math.abs(woundRad) >= 2 * Math.PI;
  }

  /** Drives until it is round or has used up its steps. */
  Course drive(long mostSteps) {
    while (!isRound() && steps < mostSteps) {
      step();
    }
    return this;
  }

  void step() {
    boolean heard = region.contains(x, z);
    sense(heard);
    controller.decide(readings, command);
    double before = Math.atan2(x, z);
    x += command.speedMPerS() * STEP_S * Math.cos(headingRad);
    z -= command.speedMPerS() * STEP_S * Math.sin(headingRad);
    headingRad += command.turnRateRadPerS() * STEP_S;
    steps++;
    boolean hears = region.contains(x, z);
    leftRegion |= heard && !hears;
    if (leftRegion) {
      woundRad += Math.IEEEremainder(Math.atan2(x, z) - before, 2 * Math.PI);
    }
  }

  /** The sonars whose cones of 27.5 degrees either side hold the post. */
  private void sense(boolean heard) {
    double towards = Math.atan2(z, -x) - headingRad;
    for (int i = 0; i < readings.size(); i++) {
      double off = Math.IEEEremainder(towards - Math.PI / 6 * i, 2 * Math.PI);
      if (heard && Math.abs(off) <= Math.toRadians(27.5)) {
        readings.setEcho(i, Math.hypot(x, z));
      } else {
        readings.setNoEcho(i);
      }
    }
  }
}
