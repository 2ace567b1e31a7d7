package simbad.blindworld.world;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/**
 * Chance that is the same on every Java that was compared (17 and 25) and on every machine: the
 * uniform numbers of the JDK's SplittableRandom, on which both agree, and normal numbers of its
 * own, since those of the JDK differ between the two.
 */
public final class Chance implements RandomGenerator {

  // Ratio of uniforms (Kinderman and Monahan 1977) with the quadratic bounds of J. L. Leva, "A fast
  // normal random number generator", ACM Transactions on Mathematical Software 18(4), 1992,
  // 449-453.
  /** The region's height: the square root of 8 / e, rounded up. */
  private static final double HEIGHT = 1.7156;

  private static final double CENTRE_U = 0.449871;
  private static final double CENTRE_V = -0.386595;
  private static final double A = 0.196;
  private static final double B = 0.25472;
  private static final double INNER = 0.27597;
  private static final double OUTER = 0.27846;

  private final SplittableRandom source;

  /** Chance that a seed determines. */
  public Chance(long seed) {
    this(new SplittableRandom(seed));
  }

  private Chance(SplittableRandom source) {
    this.source = source;
  }

  /** Further chance that shares no numbers with this one. */
  public Chance split() {
    return new Chance(source.split());
  }

  @Override
  public long nextLong() {
    return source.nextLong();
  }

  /** A number of the standard normal distribution. */
  @Override
  public double nextGaussian() {
    while (true) {
      double u = 1 - nextDouble();
      double v = HEIGHT * (nextDouble() - 0.5);
      double x = u - CENTRE_U;
      double y = Math.abs(v) - CENTRE_V;
      double q = x * x + y * (A * y - B * x);
      if (q < INNER || (q <= OUTER && v * v <= -4 * u * u * StrictMath.log(u))) {
        return v / u;
      }
    }
  }
}
