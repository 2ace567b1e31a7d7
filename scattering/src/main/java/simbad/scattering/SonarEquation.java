package simbad.scattering;

import java.util.Arrays;
import simbad.sonar.level.Air;

/**
 * From an echo's strength to the distance at which it is first missed.
 *
 * <p>On its way out to a post and back a wave loses 20 log r + 10 log r by spreading (a sphere out,
 * a cylinder about the upright post back) and 2 a r by absorption. The ranger's comparator is
 * desensitised after its own burst, and recovers within a millisecond or two: its threshold stands
 * 20 log(1 + K e^(-t/tau)) over its final value at t = 2 r / c. A bench moves outward and notes
 * where the echo is lost for the first time: the least r at which the echo lies below the
 * comparator's threshold. Immutable.
 */
final class SonarEquation {
  private static final double STEP_M = 0.001;

  /** So that 469.9999 steps count as 470. */
  private static final double SLACK = 1e-6;

  private static final double SPREADING_DB_PER_DECADE = 30;

  private final double minRangeM;

  /** Least margin of a target of 0 dB from the minimum range out to each step. */
  private final double[] leastMarginDb;

  private SonarEquation(double minRangeM, double[] leastMarginDb) {
    this.minRangeM = minRangeM;
    this.leastMarginDb = leastMarginDb;
  }

  /**
   * Sets it up.
   *
   * @param receiver comparator
   * @param air between sensor and post
   * @param limits blanking and time-out as ranges
   */
  static SonarEquation of(Receiver receiver, Air air, RangeLimits limits) {
    double lossDbPerM = 2 * air.absorptionDbPerM(Backscatter.FREQUENCY_HZ);
    double recoveryM = air.soundSpeedMPerS() * receiver.recoveryS() / 2;
    int steps = (int) Math.floor((limits.maxRangeM() - limits.minRangeM()) / STEP_M + SLACK) + 1;
    double[] margin = new double[steps];
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < steps; i++) {
      double r = limits.minRangeM() + i * STEP_M;
      double raisedDb = 20 * Math.log10(1 + receiver.desensitisation() * Math.exp(-r / recoveryM));
      double here =
          receiver.levelDb() - SPREADING_DB_PER_DECADE * Math.log10(r) - lossDbPerM * r - raisedDb;
      least = Math.min(least, here);
      margin[i] = least;
    }
    return new SonarEquation(limits.minRangeM(), margin);
  }

  /**
   * Returns the distance at which an echo is first missed.
   *
   * @param targetDb 20 log |f|
   * @return metres; 0 for one that is never heard, the maximum range for one that is never missed
   */
  double thresholdM(double targetDb) {
    // Falls with the distance, so that a search by halves finds its first negative sum.
    int low = 0;
    int high = leastMarginDb.length;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (leastMarginDb[middle] + targetDb < 0) {
        high = middle;
      } else {
        low = middle + 1;
      }
    }
    if (low == 0) {
      return 0;
    }
    return minRangeM + (low - 1 + passed(low, targetDb)) * STEP_M;
  }

  /** Share of the step before the first negative sum at which the sum passes 0. */
  private double passed(int low, double targetDb) {
    if (low == leastMarginDb.length) {
      return 0;
    }
    double before = leastMarginDb[low - 1];
    return (before + targetDb) / (before - leastMarginDb[low]);
  }

  /** Returns the thresholds of all bearings, every level raised by as many decibels. */
  double[] thresholdsM(Backscatter target, double raisedDb) {
    double[] thresholds = new double[target.size()];
    Arrays.setAll(thresholds, i -> thresholdM(target.levelDb(i) + raisedDb));
    return thresholds;
  }
}
