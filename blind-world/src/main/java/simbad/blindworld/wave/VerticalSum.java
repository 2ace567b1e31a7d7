package simbad.blindworld.wave;

import java.util.Arrays;

/**
 * The sum over a target's height of what a point at a horizontal distance sends back: directivity
 * in the vertical out and back, and the phase k z^2 / distance of the longer way. For a target
 * without ends before a small piston it is sqrt(pi distance / k), turned by an eighth.
 */
final class VerticalSum {

  private static final int STEPS = 400;
  private static final double NEAREST_M = 0.02;
  private static final double FURTHEST_M = 8;
  private static final double SLICE_M = 0.001;

  /** Further up or down than so many times the distance nothing is sent. */
  private static final double STEEPEST = 1.2;

  private final Upright upright;
  private final Medium medium;
  private final double perStep;

  /** NaN until somebody asks: a great distance needs thousands of slices. */
  private final double[] re = new double[STEPS + 2];

  private final double[] im = new double[STEPS + 2];

  VerticalSum(Upright upright, Medium medium) {
    this.upright = upright;
    this.medium = medium;
    perStep = StrictMath.log(FURTHEST_M / NEAREST_M) / STEPS;
    Arrays.fill(re, Double.NaN);
  }

  private void know(int i) {
    if (Double.isNaN(re[i])) {
      Complex sum = sum(NEAREST_M * StrictMath.exp(i * perStep));
      re[i] = sum.re();
      im[i] = sum.im();
    }
  }

  private Complex sum(double distanceM) {
    double from = Math.max(upright.bottomM(), -STEEPEST * distanceM);
    double to = Math.min(upright.topM(), STEEPEST * distanceM);
    int slices = (int) Math.ceil(Math.max(0, to - from) / SLICE_M);
    double sumRe = 0;
    double sumIm = 0;
    for (int s = 0; s < slices; s++) {
      double z = from + (s + 0.5) * (to - from) / slices;
      double sine = z / Math.sqrt(z * z + distanceM * distanceM);
      double weight = medium.sent(sine) * medium.received(sine) * taper(z / distanceM);
      double phase = -medium.perM() * z * z / distanceM;
      sumRe += weight * StrictMath.cos(phase);
      sumIm += weight * StrictMath.sin(phase);
    }
    double slice = slices == 0 ? 0 : (to - from) / slices;
    return new Complex(sumRe * slice, sumIm * slice);
  }

  /** Where the sum is broken off it fades, so that no end shows that is none. */
  private static double taper(double steepness) {
    double beyond = Math.abs(steepness) / STEEPEST;
    return beyond < 0.7 ? 1 : 0.5 * (1 + StrictMath.cos(Math.PI * (beyond - 0.7) / 0.3));
  }

  private double place(double distanceM) {
    double within = Math.max(NEAREST_M, Math.min(FURTHEST_M, distanceM));
    return StrictMath.log(within / NEAREST_M) / perStep;
  }

  /** The sum at a distance, in metres. */
  Complex at(double distanceM) {
    double place = place(distanceM);
    int i = (int) place;
    double share = place - i;
    know(i);
    know(i + 1);
    return new Complex(re[i] + share * (re[i + 1] - re[i]), im[i] + share * (im[i + 1] - im[i]));
  }
}
