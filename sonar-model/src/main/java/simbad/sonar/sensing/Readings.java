package simbad.sonar.sensing;

import java.util.Arrays;

/**
 * The latest reading of every transducer of a belt, in a buffer that is filled anew at each ping.
 *
 * <p>Exists so that sensing allocates nothing: {@link #reading(int)} is for callers outside the
 * simulation step. Not safe for use by several threads.
 */
public final class Readings {
  private final double[] rangeM;
  private final boolean[] echo;

  /**
   * Creates a buffer in which no transducer has heard anything.
   *
   * @param transducers how many; at least 0
   */
  public Readings(int transducers) {
    rangeM = new double[transducers];
    echo = new boolean[transducers];
  }

  /** Returns the number of transducers. */
  public int size() {
    return echo.length;
  }

  /** Forgets every reading: all are no-echo. */
  public void clear() {
    Arrays.fill(echo, false);
  }

  /**
   * Records an echo.
   *
   * @param transducer index, from 0
   * @param range the range in metres; finite, at least 0
   */
  public void setEcho(int transducer, double range) {
    if (!(range >= 0 && range < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("range = " + range + " is not in [0, infinity)");
    }
    rangeM[transducer] = range;
    echo[transducer] = true;
  }

  /**
   * Records that nothing was heard.
   *
   * @param transducer index, from 0
   */
  public void setNoEcho(int transducer) {
    echo[transducer] = false;
  }

  /**
   * Tells whether a transducer heard an echo.
   *
   * @param transducer index, from 0
   */
  public boolean isEcho(int transducer) {
    return echo[transducer];
  }

  /**
   * Returns the range of a transducer that heard an echo.
   *
   * @param transducer index, from 0
   * @return the range in metres
   * @throws IllegalStateException if it heard none
   */
  public double rangeM(int transducer) {
    if (!echo[transducer]) {
      throw new IllegalStateException("transducer " + transducer + " heard no echo");
    }
    return rangeM[transducer];
  }

  /**
   * Returns one reading as a value.
   *
   * @param transducer index, from 0
   */
  public Reading reading(int transducer) {
    return echo[transducer] ? new Echo(rangeM[transducer]) : NoEcho.NO_ECHO;
  }
}
