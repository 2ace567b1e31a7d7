package simbad.experiments.control;

/**
 * Where a controller believes its robot to be, from its own commands alone; the start is the
 * origin.
 */
final class Odometry {
  private final double stepS;
  private double xM;
  private double zM;
  private double headingRad;

  Odometry(double stepS) {
    this.stepS = stepS;
  }

  double xM() {
    return xM;
  }

  double zM() {
    return zM;
  }

  /** Not normalised, so that turns add up. */
  double headingRad() {
    return headingRad;
  }

  /** The simulator moves a robot along the heading that it has before the step, then turns it. */
  void advance(Command command) {
    double wayM = command.speedMPerS() * stepS;
    xM += wayM * Math.cos(headingRad);
    zM -= wayM * Math.sin(headingRad);
    headingRad += command.turnRateRadPerS() * stepS;
  }
}
