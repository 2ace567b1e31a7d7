package simbad.gap.explain;

import java.util.Random;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Refit;

/**
 * How far the gap shrinks on rows that the fit never saw: each half of the blocks is predicted by
 * values that were fitted on the other half; a table of thresholds a sixth by the rest.
 *
 * @param before gap of each ping under the simulator as it is
 * @param after gap of each ping under the explanation
 */
public record Gain(GapMeter.Gaps before, GapMeter.Gaps after) {
  private static final int RESAMPLES = 1000;
  private static final int EVALUATIONS = 20;

  /** Half of a log may lack whole sides of an obstacle, which a table cannot know then. */
  private static final int TABLE_PARTS = 6;

  /** Measures. */
  public static Gain of(Evidence evidence, Blocks blocks, Hypothesis explanation) {
    GapMeter meter = new GapMeter(evidence);
    GapMeter.Gaps before = meter.measure(evidence, Hypothesis.NONE);
    if (explanation.size() == 0) {
      return new Gain(before, before);
    }
    double[] observed = new double[evidence.log().size()];
    double[] expected = new double[observed.length];
    int parts = explanation.hasTable() ? TABLE_PARTS : 2;
    for (int part = 0; part < parts; part++) {
      Fold left = blocks.part(part, parts);
      Hypothesis fitted =
          new Refit(evidence, ping -> !left.holds(ping)).of(explanation, EVALUATIONS);
      GapMeter.Gaps gaps = meter.measure(evidence, fitted);
      for (int i = 0; i < observed.length; i++) {
        if (left.holds(i)) {
          observed[i] = gaps.observedM()[i];
          expected[i] = gaps.expectedM()[i];
        }
      }
    }
    return new Gain(before, new GapMeter.Gaps(observed, expected));
  }

  /** Returns the mean gap before, metres. */
  public double beforeM() {
    return mean(before.observedM());
  }

  /** Returns the mean gap after, metres. */
  public double afterM() {
    return mean(after.observedM());
  }

  /** Returns the gap that a right model would leave, as the explanation itself expects, metres. */
  public double floorM() {
    return Math.min(afterM(), mean(after.expectedM()));
  }

  private static double mean(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value;
    }
    return values.length == 0 ? 0 : sum / values.length;
  }

  /**
   * Returns the shrinkages, sorted, of resampled logs: as many blocks drawn with replacement.
   *
   * @param blocks that are drawn
   * @param seed of the draws
   */
  public double[] resampled(Blocks blocks, long seed) {
    double[] beforeSums = sums(before.observedM(), blocks);
    double[] afterSums = sums(after.observedM(), blocks);
    Random random = new Random(seed);
    double[] shrinks = new double[RESAMPLES];
    for (int draw = 0; draw < RESAMPLES; draw++) {
      double was = 0;
      double is = 0;
      for (int i = 0; i < beforeSums.length; i++) {
        int block = random.nextInt(beforeSums.length);
        was += beforeSums[block];
        is += afterSums[block];
      }
      shrinks[draw] = was > 0 ? 1 - is / was : 0;
    }
    java.util.Arrays.sort(shrinks);
    return shrinks;
  }

  private static double[] sums(double[] values, Blocks blocks) {
    double[] sums = new double[blocks.count()];
    for (int i = 0; i < values.length; i++) {
      sums[blocks.of(i)] += values[i];
    }
    return sums;
  }
}
