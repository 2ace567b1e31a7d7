package simbad.sonar.model;

import java.util.List;
import java.util.random.RandomGenerator;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;

/**
 * The distribution of one reading: some probability of no echo, the rest spread over the distances
 * that may answer, each with Gaussian noise and rounded down to the sensor's resolution.
 *
 * <p>A reading that noise would take below 0 is 0. Immutable.
 */
public final class ReadingDistribution {
  private final double[] distanceM;
  private final double[] probability;
  private final double noEchoProbability;
  private final double noiseM;
  private final double resolutionM;

  private ReadingDistribution(
      double[] distanceM, double[] probability, double noiseM, double resolutionM) {
    this.distanceM = distanceM;
    this.probability = probability;
    this.noiseM = noiseM;
    this.resolutionM = resolutionM;
    double heard = 0;
    for (double share : probability) {
      heard += share;
    }
    noEchoProbability = Math.max(0, 1 - heard);
  }

  /** Of obstacles that may answer, nearest first: each is read when no nearer one answers. */
  static ReadingDistribution nearestFirst(List<Sight> heard, double noiseM, double resolutionM) {
    double[] distance = new double[heard.size()];
    double[] share = new double[heard.size()];
    double silent = 1;
    for (int i = 0; i < distance.length; i++) {
      Sight sight = heard.get(i);
      distance[i] = sight.nearestM().orElseThrow();
      share[i] = silent * sight.echoProbability();
      silent *= 1 - sight.echoProbability();
    }
    return new ReadingDistribution(distance, share, noiseM, resolutionM);
  }

  /** Returns the probability of no echo, in [0, 1]. */
  public double noEchoProbability() {
    return noEchoProbability;
  }

  /**
   * Returns the probability of an echo that reads at most a range.
   *
   * @param rangeM metres, any number, infinity included
   * @return in [0, 1 - noEchoProbability]
   */
  public double echoUpTo(double rangeM) {
    requireNumber("rangeM", rangeM);
    if (rangeM < 0) {
      return 0;
    }
    double sum = 0;
    for (int i = 0; i < distanceM.length; i++) {
      sum += probability[i] * readsUpTo(rangeM, distanceM[i]);
    }
    return sum;
  }

  /** The probability that what answers from a distance reads at most a range. */
  private double readsUpTo(double rangeM, double fromM) {
    if (!(noiseM > 0)) {
      return roundedDown(fromM) <= roundedDown(rangeM) ? 1 : 0;
    }
    // All that is rounded down to this range lies below the next step.
    double below = resolutionM > 0 ? (stepOf(rangeM) + 1) * resolutionM : rangeM;
    return NormalDistribution.cumulative((below - fromM) / noiseM);
  }

  /**
   * Returns the probability that an echo falls into the step of the resolution that holds a range.
   *
   * @param rangeM metres, at least 0
   * @throws IllegalStateException if the sensor has no resolution, for then each single range has
   *     probability 0
   */
  public double probabilityOfStep(double rangeM) {
    if (!(resolutionM > 0)) {
      throw new IllegalStateException("resolutionM = 0: a single range has probability 0");
    }
    requireNumber("rangeM", rangeM);
    double step = stepOf(rangeM);
    return echoUpTo((step + 0.5) * resolutionM) - echoUpTo((step - 0.5) * resolutionM);
  }

  /**
   * Returns a quantile of the reading, no-echo counted as a range: the least range that is not
   * exceeded with at least the given probability.
   *
   * @param level in (0, 1)
   * @param noEchoM the range that a no-echo counts as, metres
   * @return metres
   */
  public double quantileM(double level, double noEchoM) {
    if (!(level > 0 && level < 1)) {
      throw new IllegalArgumentException("level = " + level + " is not in (0, 1)");
    }
    requireNumber("noEchoM", noEchoM);
    double upToNoEcho = echoUpTo(noEchoM);
    if (upToNoEcho >= level && noEchoM > 0) {
      return Math.min(echoQuantileM(level), noEchoM);
    }
    return upToNoEcho + noEchoProbability >= level
        ? noEchoM
        : echoQuantileM(level - noEchoProbability);
  }

  /** The least range with echoUpTo(range) at or above a probability that echoes do reach. */
  private double echoQuantileM(double reached) {
    double low = 0;
    double high = 1;
    while (echoUpTo(high) < reached && high < Double.MAX_VALUE / 2) {
      low = high;
      high *= 2;
    }
    for (int i = 0; i < 200 && Math.nextUp(low) < high; i++) {
      double middle = (low + high) / 2;
      if (echoUpTo(middle) >= reached) {
        high = middle;
      } else {
        low = middle;
      }
    }
    return roundedDown(high);
  }

  /** Draws a reading. */
  public Reading sample(RandomGenerator random) {
    double draw = random.nextDouble();
    double noise = noiseM > 0 ? noiseM * random.nextGaussian() : 0;
    for (int i = 0; i < distanceM.length; i++) {
      draw -= probability[i];
      if (draw < 0) {
        return new Echo(Math.max(0, roundedDown(distanceM[i] + noise)));
      }
    }
    return NoEcho.NO_ECHO;
  }

  private static void requireNumber(String name, double value) {
    if (Double.isNaN(value)) {
      throw new IllegalArgumentException(name + " = NaN is not a number");
    }
  }

  private double stepOf(double rangeM) {
    // A range that was written with few decimals lies a rounding error beside its step.
    return Math.floor(rangeM / resolutionM + 1e-9);
  }

  private double roundedDown(double rangeM) {
    return resolutionM > 0 ? stepOf(rangeM) * resolutionM : rangeM;
  }
}
