package simbad.blindworld.wave;

/**
 * Echoes on the time axis of one ping, as complex envelopes at whole carrier cycles after the
 * trigger. First bare arrivals are added, then the burst's envelope is drawn through them.
 */
public final class Trace {

  private final int first;
  private final double[] re;
  private final double[] im;

  /** An empty trace of so many cycles from the first on. */
  Trace(int first, int length) {
    this.first = first;
    re = new double[length];
    im = new double[length];
  }

  /** A trace that holds nothing. */
  static Trace silent() {
    return new Trace(0, 0);
  }

  /** The cycle of the first value. */
  int first() {
    return first;
  }

  int length() {
    return re.length;
  }

  /** The value at a cycle, real part; 0 outside. */
  double re(int cycle) {
    return holds(cycle) ? re[cycle - first] : 0;
  }

  /** The value at a cycle, imaginary part; 0 outside. */
  double im(int cycle) {
    return holds(cycle) ? im[cycle - first] : 0;
  }

  boolean holds(int cycle) {
    return cycle >= first && cycle < first + re.length;
  }

  /** Adds an arrival at a time in cycles, shared out between the two cycles next to it. */
  void add(double cycles, double realPart, double imaginaryPart) {
    int cycle = (int) Math.floor(cycles);
    double later = cycles - cycle;
    put(cycle, (1 - later) * realPart, (1 - later) * imaginaryPart);
    put(cycle + 1, later * realPart, later * imaginaryPart);
  }

  private void put(int cycle, double realPart, double imaginaryPart) {
    if (holds(cycle)) {
      re[cycle - first] += realPart;
      im[cycle - first] += imaginaryPart;
    }
  }

  /** Adds another trace times a factor, where this one reaches. */
  void add(Trace other, double factor) {
    for (int i = 0; i < other.re.length; i++) {
      put(other.first + i, factor * other.re[i], factor * other.im[i]);
    }
  }

  /** Each arrival as the whole echo that it is. */
  Trace drawn(Complex[] pulse) {
    Trace whole = new Trace(first, re.length + pulse.length);
    for (int i = 0; i < re.length; i++) {
      if (re[i] != 0 || im[i] != 0) {
        for (int n = 0; n < pulse.length; n++) {
          whole.re[i + n] += re[i] * pulse[n].re() - im[i] * pulse[n].im();
          whole.im[i + n] += re[i] * pulse[n].im() + im[i] * pulse[n].re();
        }
      }
    }
    return whole;
  }

  /** The greatest size. */
  double most() {
    double most = 0;
    for (int i = 0; i < re.length; i++) {
      most = Math.max(most, StrictMath.hypot(re[i], im[i]));
    }
    return most;
  }
}
