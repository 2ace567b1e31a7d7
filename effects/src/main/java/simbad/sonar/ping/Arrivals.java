package simbad.sonar.ping;

import java.util.Arrays;

/** What may answer one ping, by distance; reused from ping to ping. */
public final class Arrivals {
  private int size;
  private double[] distanceM = new double[8];
  private double[] deviationM = new double[8];
  private double[] probability = new double[8];

  /** Creates an empty list. */
  public Arrivals() {}

  /** Takes everything out. */
  public void clear() {
    size = 0;
  }

  /**
   * Takes over what stands in some arrays, the nearest first, in the place of its own.
   *
   * @param fromDistanceM metres
   * @param fromDeviationM metres
   * @param fromProbability that each answers
   * @param first index of the first
   * @param count how many
   */
  public void take(
      double[] fromDistanceM,
      double[] fromDeviationM,
      double[] fromProbability,
      int first,
      int count) {
    if (distanceM.length < count) {
      distanceM = new double[count];
      deviationM = new double[count];
      probability = new double[count];
    }
    size = count;
    System.arraycopy(fromDistanceM, first, distanceM, 0, count);
    System.arraycopy(fromDeviationM, first, deviationM, 0, count);
    System.arraycopy(fromProbability, first, probability, 0, count);
  }

  /**
   * Writes all into some arrays, the nearest first.
   *
   * @param intoDistanceM metres
   * @param intoDeviationM metres
   * @param intoProbability that each answers
   * @param first index of the first
   * @return how many there are
   */
  public int put(
      double[] intoDistanceM, double[] intoDeviationM, double[] intoProbability, int first) {
    System.arraycopy(distanceM, 0, intoDistanceM, first, size);
    System.arraycopy(deviationM, 0, intoDeviationM, first, size);
    System.arraycopy(probability, 0, intoProbability, first, size);
    return size;
  }

  /**
   * Adds what may answer.
   *
   * @param newDistanceM metres
   * @param newDeviationM own scatter beside the sensor's, metres; 0 for none
   * @param newProbability that it answers; nothing is added at 0
   */
  public void add(double newDistanceM, double newDeviationM, double newProbability) {
    if (!(newProbability > 0)) {
      return;
    }
    if (size == distanceM.length) {
      distanceM = Arrays.copyOf(distanceM, 2 * size);
      deviationM = Arrays.copyOf(deviationM, 2 * size);
      probability = Arrays.copyOf(probability, 2 * size);
    }
    // Kept nearest first; of equals the one that was added first, as the nominal model has it.
    int at = size++;
    while (at > 0 && distanceM[at - 1] > newDistanceM) {
      distanceM[at] = distanceM[at - 1];
      deviationM[at] = deviationM[at - 1];
      probability[at] = probability[at - 1];
      at--;
    }
    distanceM[at] = newDistanceM;
    deviationM[at] = newDeviationM;
    probability[at] = newProbability;
  }

  /** Makes the mixture of first echoes: each is read when no nearer one answers. */
  public void mix(Mixture into) {
    into.clear();
    double silent = 1;
    for (int i = 0; i < size; i++) {
      into.add(distanceM[i], deviationM[i], silent * probability[i]);
      silent *= 1 - probability[i];
    }
  }
}
