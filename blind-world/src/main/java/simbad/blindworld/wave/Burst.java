package simbad.blindworld.wave;

import java.util.Arrays;
import simbad.blindworld.check.Checks;

/**
 * What is sent, and what two resonances make of it.
 *
 * @param frequencyHz of the carrier
 * @param cycles of the carrier in a burst
 * @param sender resonance of the transmitter
 * @param receiver resonance of the receiver
 * @param delayS from the trigger to the burst's begin
 */
public record Burst(
    double frequencyHz, int cycles, Resonance sender, Resonance receiver, double delayS) {
  /** Refuses what is no such thing. */
  public Burst {
    Checks.positive("frequency", frequencyHz);
    Checks.finite("delay", delayS);
  }

  /** After so many cycles an echo is over. */
  private static final int MOST_CYCLES = 160;

  private static final double FAINTEST = 2e-3;

  /**
   * A second-order resonance.
   *
   * @param frequencyHz at which it answers most
   * @param quality frequency over bandwidth
   */
  public record Resonance(double frequencyHz, double quality) {
    /** Refuses what is no such thing. */
    public Resonance {
      Checks.positive("frequency", frequencyHz);
      Checks.positive("quality", quality);
    }

    /** The pole of its envelope beside a carrier, in 1/s: decay, and beat. */
    Complex pole(double carrierHz) {
      return new Complex(-decayPerS(), 2 * Math.PI * (frequencyHz - carrierHz));
    }

    double decayPerS() {
      return Math.PI * frequencyHz / quality;
    }
  }

  /** The same burst with another number of cycles. */
  public Burst withCycles(int number) {
    return new Burst(frequencyHz, number, sender, receiver, delayS);
  }

  /** The same burst on another carrier. */
  public Burst withFrequency(double otherHz) {
    return new Burst(otherHz, cycles, sender, receiver, delayS);
  }

  /** The same burst, later after its trigger by so much. */
  public Burst delayed(double byS) {
    return new Burst(frequencyHz, cycles, sender, receiver, delayS + byS);
  }

  /**
   * The envelope of a single echo of strength 1, relative to the carrier, {@code tS} after its
   * begin; 1 is what an endless burst on the resonances would reach.
   */
  Complex envelope(double tS) {
    double lengthS = cycles / frequencyHz;
    Complex on = step(tS);
    return tS > lengthS ? on.minus(step(tS - lengthS)) : on;
  }

  /** The answer of both resonances to a carrier switched on, by partial fractions. */
  private Complex step(double tS) {
    if (tS <= 0) {
      return new Complex(0, 0);
    }
    Complex p = sender.pole(frequencyHz);
    Complex q = receiver.pole(frequencyHz);
    if (p.minus(q).size() < 1) {
      // Two equal poles have another formula, from which a hertz apart cannot be told.
      q = q.plus(new Complex(1, 1));
    }
    Complex rest = new Complex(1, 0).over(p.times(q));
    Complex first = p.times(tS).exp().over(p.times(p.minus(q)));
    Complex second = q.times(tS).exp().over(q.times(q.minus(p)));
    return rest.plus(first).plus(second).times(sender.decayPerS() * receiver.decayPerS());
  }

  /** The envelope at whole cycles after the echo's begin, until it is over. */
  Complex[] pulse() {
    Complex[] all = new Complex[MOST_CYCLES];
    double most = 0;
    int last = 0;
    for (int n = 0; n < all.length; n++) {
      all[n] = envelope(n / frequencyHz);
      most = Math.max(most, all[n].size());
      last = all[n].size() > FAINTEST * most ? n : last;
    }
    return Arrays.copyOf(all, last + 1);
  }
}
