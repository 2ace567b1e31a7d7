package simbad.sonar.level;

/** Decibels and the ratios of energies that they stand for. */
public final class Decibels {
  private static final double PER_NEPER_OF_ENERGY = 10 / Math.log(10);

  private Decibels() {}

  /**
   * Returns the ratio of energies, 10^(level / 10).
   *
   * @param levelDb any number; negative infinity is a ratio of 0
   */
  public static double energy(double levelDb) {
    return Math.exp(levelDb / PER_NEPER_OF_ENERGY);
  }

  /**
   * Returns the level in decibels, 10 log10 of a ratio of energies.
   *
   * @param energy at least 0; of 0 it is negative infinity
   */
  public static double level(double energy) {
    return PER_NEPER_OF_ENERGY * Math.log(energy);
  }
}
