package simbad.blindworld.motion;

import java.util.random.RandomGenerator;
import simbad.blindworld.check.Checks;

/** Gaussian noise of variance 1 that hangs together over a while; a value for each step. */
public final class Wandering {
  private final double keep;
  private final double fresh;
  private final RandomGenerator random;
  private double value;

  /** With a correlation time; begun as it goes on. */
  public Wandering(double constantS, RandomGenerator random) {
    Checks.notNegative("correlation time", constantS);
    keep = constantS > 0 ? StrictMath.exp(-MotionWorld.STEP_S / constantS) : 0;
    fresh = Math.sqrt(1 - keep * keep);
    this.random = random;
    value = random.nextGaussian();
  }

  /** The next one. */
  public double next() {
    value = keep * value + fresh * random.nextGaussian();
    return value;
  }
}
