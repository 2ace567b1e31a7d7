package simbad.blindworld.world;

import java.util.random.RandomGenerator;

/** Chance that says the given numbers, again and again. */
public final class FixedChance implements RandomGenerator {

  private final double[] shares;
  private double[] gaussians = {0};
  private boolean[] coins = {true};
  private int share;
  private int gaussian;
  private int coin;

  /** Numbers in [0, 1); whole numbers below n are n times those, rounded down. */
  public FixedChance(double... shares) {
    this.shares = shares.clone();
  }

  /** With these instead of the mean of a Gaussian. */
  public FixedChance gaussian(double... values) {
    gaussians = values.clone();
    return this;
  }

  /** With these instead of always true. */
  public FixedChance coins(boolean... values) {
    coins = values.clone();
    return this;
  }

  /** How many numbers in [0, 1) have been asked for. */
  public int asked() {
    return share;
  }

  @Override
  public double nextDouble() {
    return shares[share++ % shares.length];
  }

  @Override
  public double nextGaussian() {
    return gaussians[gaussian++ % gaussians.length];
  }

  @Override
  public boolean nextBoolean() {
    return coins[coin++ % coins.length];
  }

  @Override
  public int nextInt(int bound) {
    return (int) (nextDouble() * bound);
  }

  @Override
  public int nextInt(int origin, int bound) {
    return origin + nextInt(bound - origin);
  }

  @Override
  public long nextLong() {
    return (long) (nextDouble() * Long.MAX_VALUE);
  }
}
