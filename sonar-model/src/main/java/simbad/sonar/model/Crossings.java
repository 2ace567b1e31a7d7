package simbad.sonar.model;

import java.util.Arrays;
import simbad.sonar.level.Decibels;
import simbad.sonar.level.LevelLaw;

/**
 * The echoes of one ping as they reach the receiver, and where each crosses its threshold.
 *
 * <p>At the moment at which an echo arrives the energies of those that came less than a pulse
 * length before it are there as well; the receiver sees the sum. It crosses later by the walk of
 * that sum. The scatter of a ping is one for echoes that overlap and independent for those that do
 * not: nothing is heard up to the k-th crossing with the probability S_k = min(S_k-1, S_b (1 -
 * P_k)), P_k being the chance of the sum and b the last crossing before it that it does not
 * overlap. A buffer that is filled anew.
 */
final class Crossings {
  /** Of energies; so near to the threshold an echo lies on it, rounded. */
  private static final double ROUNDING = 1e-9;

  /** In standard deviations: what lacks so many crosses once in 10^19 pings. */
  private static final double NEVER = 9;

  private final LevelLaw law;
  private final double missRate;
  private int size;
  private double[] distanceM = new double[4];
  private double[] energy = new double[4];
  private double[] excessDb = new double[4];
  private double[] crossingM = new double[4];
  private double[] silence = new double[4];

  /** Of echoes, in the order in which they cross. */
  private int[] order = new int[4];

  Crossings(LevelLaw law, double missRate) {
    this.law = law;
    this.missRate = missRate;
  }

  void clear() {
    size = 0;
  }

  int size() {
    return size;
  }

  /**
   * Adds an echo.
   *
   * @param fromM distance to the point that answers, metres
   * @param ownEnergy over the threshold's
   */
  void add(double fromM, double ownEnergy) {
    if (size == distanceM.length) {
      distanceM = Arrays.copyOf(distanceM, 2 * size);
      energy = Arrays.copyOf(energy, 2 * size);
      excessDb = Arrays.copyOf(excessDb, 2 * size);
      crossingM = Arrays.copyOf(crossingM, 2 * size);
      silence = Arrays.copyOf(silence, 2 * size);
      order = Arrays.copyOf(order, 2 * size);
    }
    distanceM[size] = fromM;
    energy[size] = ownEnergy;
    size++;
  }

  /** What is at the receiver when an echo arrives. */
  private double totalEnergy(int echo) {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      double before = distanceM[echo] - distanceM[i];
      sum += before >= 0 && before <= law.pulseLengthM() ? energy[i] : 0;
    }
    return sum;
  }

  /** Where the first echo crosses if nothing scatters or is missed; infinity for none. */
  double firstM() {
    double first = Double.POSITIVE_INFINITY;
    for (int i = 0; i < size; i++) {
      if (distanceM[i] + law.walkM().least() < first) {
        double total = totalEnergy(i);
        if (total >= 1 - ROUNDING) {
          first = Math.min(first, distanceM[i] + law.walkM().at(Decibels.level(total)));
        }
      }
    }
    return first;
  }

  /** Computes where and with which probability each echo is the first to cross. */
  void settle() {
    for (int i = 0; i < size; i++) {
      excessDb[i] = Decibels.level(totalEnergy(i));
      crossingM[i] = distanceM[i] + law.walkM().at(excessDb[i]);
      order[i] = i;
      for (int k = i; k > 0 && isBefore(order[k], order[k - 1]); k--) {
        int later = order[k - 1];
        order[k - 1] = order[k];
        order[k] = later;
      }
    }
    for (int k = 0; k < size; k++) {
      double heard = chance(excessDb[order[k]], law.excessSdDb(), missRate);
      silence[k] = Math.min(silenceBefore(k), silenceApart(k) * (1 - heard));
    }
  }

  private boolean isBefore(int echo, int other) {
    return crossingM[echo] != crossingM[other]
        ? crossingM[echo] < crossingM[other]
        : distanceM[echo] < distanceM[other];
  }

  private double silenceBefore(int crossing) {
    return crossing == 0 ? 1 : silence[crossing - 1];
  }

  /** Up to the last crossing before it with which it does not overlap. */
  private double silenceApart(int crossing) {
    double at = distanceM[order[crossing]];
    for (int k = crossing - 1; k >= 0; k--) {
      if (Math.abs(distanceM[order[k]] - at) > law.pulseLengthM()) {
        return silence[k];
      }
    }
    return 1;
  }

  /** The probability that a settled crossing is the one that is read. */
  double share(int crossing) {
    return silenceBefore(crossing) - silence[crossing];
  }

  /** The probability that nothing is heard up to a settled crossing. */
  double silence(int crossing) {
    return silence[crossing];
  }

  /** Where a settled crossing reads in the mean, metres. */
  double meanM(int crossing) {
    return crossingM[order[crossing]];
  }

  /** How much a settled crossing's range scatters, metres. */
  double deviationM(int crossing) {
    return law.noiseM().at(excessDb[order[crossing]]);
  }

  /** The chance that an echo is heard: (1 - missRate) Phi(excess / sd). */
  static double chance(double excessDb, double sdDb, double missRate) {
    if (!(sdDb > 0)) {
      return excessDb >= -ROUNDING ? 1 - missRate : 0;
    }
    double deviations = excessDb / sdDb;
    return deviations < -NEVER ? 0 : (1 - missRate) * NormalDistribution.cumulative(deviations);
  }
}
