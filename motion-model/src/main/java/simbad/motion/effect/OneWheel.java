package simbad.motion.effect;

import simbad.motion.MotionChange;

/**
 * One of two wheels goes further than it should, in proportion to its own way. The rim of the right
 * wheel goes r = v + w b/2, and each metre too much of it turns the robot by 1/b and takes its
 * middle half a metre on; of the left wheel the same is true with b below 0.
 *
 * @param perMetreRad turn for each metre of the rim, rad/m
 * @param baseM from one wheel to the other, m; above 0 for the right wheel, below for the left
 */
record OneWheel(double perMetreRad, double baseM) implements MotionChange {
  @Override
  public double speed(double speedMPerS, double turnRadPerS) {
    double extra = perMetreRad * baseM / 2 * (speedMPerS + turnRadPerS * baseM / 2);
    return extra == 0 ? speedMPerS : speedMPerS + extra;
  }

  /** The speed is that of the changed wheel: what it was before, the first line says. */
  @Override
  public double turn(double turnRadPerS, double speedMPerS) {
    double half = perMetreRad * baseM / 2;
    double before = (speedMPerS - half * turnRadPerS * baseM / 2) / (1 + half);
    double extra = perMetreRad * (before + turnRadPerS * baseM / 2);
    return extra == 0 ? turnRadPerS : turnRadPerS + extra;
  }
}
