package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;

class WhiteningTest {
  private static MotionSteps given(int poses) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i < poses; i++) {
      track.add(new TrackPose(0.2 * i, 0, 0, 0));
    }
    return new MotionSteps(List.of(new MotionRun("a", List.of(new Command(0, 1, 0)), track)));
  }

  /**
   * Two differences of three independent errors of variance s2 have covariance s2 (2 -1; -1 2),
   * with determinant 3 s2^2; for r = (a, b) the quadratic form is 2 (a2 + ab + b2) / (3 s2).
   */
  @Test
  void trackerErrors_areDifferencesOfEnds() {
    double a = 0.7;
    double b = -0.4;
    Whitening white = new Whitening(given(3), Noise.believed(1), new double[] {a, b});

    double form = 2 * (a * a + a * b + b * b) / 3;
    double gaussian = -form / 2 - Math.log(2 * Math.PI) - Math.log(3) / 2;
    assertEquals(gaussian, white.logDensity(), 0.03);
    assertEquals(form, square(white.white), 0.02);
  }

  private static double square(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value * value;
    }
    return sum;
  }

  /** With the gains as they are the filter is linear: what it makes of residuals themselves. */
  @Test
  void columns_areMadeWhiteByTheSameFilter() {
    SplittableRandom random = new SplittableRandom(5);
    double[] residuals = random.doubles(50, -1, 1).toArray();
    Noise noise = new Noise(0.3, 0.5, 4);
    Whitening white = new Whitening(given(51), noise, residuals);

    double[] again = white.of(residuals);
    for (int i = 0; i < again.length; i++) {
      assertEquals(white.white[i], again[i], 1e-12);
    }
  }

  /** A slip of ten sigma is one surprise; what follows is no surprise any more. */
  @Test
  void slip_isOneEvent() {
    double[] residuals = new double[40];
    residuals[20] = 10;
    Whitening white = new Whitening(given(41), new Noise(0.5, 0.1, 4), residuals);

    assertTrue(Math.abs(white.white[20]) > 4, "seen");
    assertTrue(Math.abs(white.white[22]) < 2, "over: " + white.white[22]);
  }

  /** Noise that was put in is found again: tracker 2, process 3 in a root of a second. */
  @Test
  void noise_isFound() {
    SplittableRandom random = new SplittableRandom(7);
    double[] residuals = new double[1500];
    double error = 2 * random.nextGaussian();
    for (int i = 0; i < residuals.length; i++) {
      double next = 2 * random.nextGaussian();
      residuals[i] = next - error + 3 * Math.sqrt(0.2) * random.nextGaussian();
      error = next;
    }
    double[][] three = {residuals, residuals, residuals};
    MotionSteps given = given(1501);
    // The load of a robot at one speed is 1.05 throughout.
    Noise found = NoiseFit.afresh(given, three)[0];
    assertEquals(2, found.tracker(), 0.2);
    assertEquals(Math.sqrt(2 * 4 + 9 * 0.5), Math.sqrt(found.variance(0.5, 1)), 0.4);
  }

  /** Of many factors one logarithm is as good as one of each. */
  @Test
  void logProduct_isTheSumOfTheLogarithms() {
    SplittableRandom random = new SplittableRandom(9);
    LogProduct product = new LogProduct();
    double sum = 0;
    assertEquals(0, product.log());
    for (int i = 0; i < 3000; i++) {
      double factor = Math.exp(random.nextDouble(-40, 30));
      product.times(factor);
      sum += Math.log(factor);
    }
    assertEquals(sum, product.log(), 1e-8);
  }

  /** A log of 500 s is sampled by every second of its blocks, and these are as they were. */
  @Test
  void sample_isAPartOfALongLog() {
    MotionSteps given = given(2501);
    MotionSteps sample = given.sample();
    assertEquals(50, given.blockCount());
    assertEquals(1250, sample.size());
    double[][] all = given.residuals(MotionChain.EXACT);
    double[][] some = sample.residuals(MotionChain.EXACT);
    for (int i = 0; i < 50; i++) {
      assertEquals(given.step(i).from(), sample.step(i).from());
      assertEquals(given.step(100 + i).to(), sample.step(50 + i).to());
      assertEquals(all[0][100 + i], some[0][50 + i], 1e-9);
    }
    MotionSteps shorter = given(1000);
    assertSame(shorter, shorter.sample());
  }
}
