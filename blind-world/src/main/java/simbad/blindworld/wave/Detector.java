package simbad.blindworld.wave;

import java.util.Arrays;
import java.util.random.RandomGenerator;

/**
 * Waits until the envelope of echoes and noise rises over the falling threshold. The comparator
 * fires at a crest of the carrier, so that a fainter echo is found whole periods later.
 */
final class Detector {

  /** Noise of so many standard deviations is reckoned with when cycles are left out. */
  private static final double RARE = 4.5;

  private static final double LEAST_HAZARD = 1e-9;

  private final double frequencyHz;
  private final double noise;
  private final double keeps;
  private final int armed;
  private final double[] threshold;
  private final double[] hazard;

  Detector(Gear gear) {
    Gear.Receiver receiver = gear.receiver();
    frequencyHz = gear.burst().frequencyHz();
    noise = receiver.noise();
    keeps = StrictMath.exp(-Math.PI / gear.burst().receiver().quality());
    armed = (int) Math.ceil(receiver.armS() * frequencyHz);
    int end = Math.max(armed, (int) Math.floor(receiver.timeoutS() * frequencyHz));
    threshold = new double[end + 1];
    hazard = new double[end + 1];
    double sum = 0;
    for (int cycle = 0; cycle <= end; cycle++) {
      threshold[cycle] = receiver.thresholdAt(cycle / frequencyHz);
      double ratio = threshold[cycle] / noise;
      sum += cycle < armed ? 0 : (1 - keeps) * StrictMath.exp(-0.5 * ratio * ratio);
      hazard[cycle] = sum;
    }
  }

  /** The last cycle that is listened to. */
  int end() {
    return threshold.length - 1;
  }

  int armed() {
    return armed;
  }

  double threshold(int cycle) {
    return threshold[cycle];
  }

  /** True when echoes that add up to a size may be heard at a cycle. */
  boolean mayHear(double size, int cycle) {
    return size > 0.02 * threshold[cycle] && size + RARE * noise >= threshold[cycle];
  }

  /** When noise alone is taken for an echo; infinite when it is not. */
  double falseAlarmS(RandomGenerator random) {
    if (hazard[end()] < LEAST_HAZARD) {
      return Double.POSITIVE_INFINITY;
    }
    double exposure = -StrictMath.log(1 - random.nextDouble());
    int place = Arrays.binarySearch(hazard, exposure);
    int cycle = place < 0 ? -place - 1 : place;
    return cycle > end() ? Double.POSITIVE_INFINITY : (cycle + random.nextDouble()) / frequencyHz;
  }

  /**
   * When an echo is detected, after the trigger.
   *
   * @param sound what arrives
   * @param factors by which each reflector's part is turned and scaled on this ping
   * @param random noise
   * @return in seconds; infinite when it is not
   */
  double firstS(Sound sound, Complex[] factors, RandomGenerator random) {
    double noiseRe = 0;
    double noiseIm = 0;
    double fresh = noise * Math.sqrt(1 - keeps * keeps);
    int last = -2;
    boolean high = false;
    for (int i = 0; i < sound.size(); i++) {
      int cycle = sound.cycle(i);
      boolean joins = cycle == last + 1;
      double was = joins ? keeps : 0;
      double adds = joins ? fresh : noise;
      noiseRe = was * noiseRe + adds * random.nextGaussian();
      noiseIm = was * noiseIm + adds * random.nextGaussian();
      double re = noiseRe + sound.re(i, factors);
      double im = noiseIm + sound.im(i, factors);
      boolean over = re * re + im * im >= threshold[cycle] * threshold[cycle];
      // A comparator that is high when ringing ends fires when it has been low in between.
      boolean still = cycle == armed || (joins && high);
      if (over && !still) {
        return (cycle - StrictMath.atan2(im, re) / (2 * Math.PI)) / frequencyHz;
      }
      high = over;
      last = cycle;
    }
    return Double.POSITIVE_INFINITY;
  }
}
