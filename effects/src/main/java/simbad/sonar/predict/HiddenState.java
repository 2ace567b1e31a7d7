package simbad.sonar.predict;

import java.util.Arrays;
import simbad.sonar.change.Burst;
import simbad.sonar.change.StaleReading;

/**
 * What the hidden-state filter of {@link Likelihood} knows: how probable each state of what
 * readings do not show is: whether the sensor is in a burst, and how often the reading before was
 * repeated already.
 *
 * <p>In slot 0 the ping before read nothing that could be repeated; in slot 1 + n its reading had
 * been repeated n times, so that slot 1 is a true echo.
 */
final class HiddenState {
  /** The slot of a true echo. */
  static final int ECHO = 1;

  private final double[][] probability = new double[2][StaleReading.MOST_REPEATS + 2];
  private int slots = 1;

  /** Nothing is known, nothing has been read. */
  void start(double inBurst) {
    clear();
    add(0, 0, 1 - inBurst);
    add(1, 0, inBurst);
  }

  void clear() {
    Arrays.fill(probability[0], 0, slots, 0);
    Arrays.fill(probability[1], 0, slots, 0);
    slots = 1;
  }

  int slots() {
    return slots;
  }

  double get(int inBurst, int slot) {
    return probability[inBurst][slot];
  }

  void add(int inBurst, int slot, double more) {
    if (slot <= StaleReading.MOST_REPEATS + 1) {
      probability[inBurst][slot] += more;
      slots = Math.max(slots, slot + 1);
    }
  }

  /** The probability of a state of the burst. */
  double sum(int inBurst) {
    double[] some = probability[inBurst];
    double sum = 0;
    for (int slot = 0; slot < slots; slot++) {
      sum += some[slot];
    }
    return sum;
  }

  /** Lets a ping's time pass for the burst. */
  void pass(Burst burst) {
    for (int slot = 0; slot < slots; slot++) {
      double clear = probability[0][slot];
      double silenced = probability[1][slot];
      probability[1][slot] = silenced * (1 - burst.ends()) + clear * burst.begins();
      probability[0][slot] = clear * (1 - burst.begins()) + silenced * burst.ends();
    }
  }

  /** Makes all probabilities add up to 1 that add up to a sum. */
  void divide(double sum) {
    for (double[] some : probability) {
      for (int slot = 0; slot < slots; slot++) {
        some[slot] /= sum;
      }
    }
  }
}
