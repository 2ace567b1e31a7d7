package simbad.gap.score;

import java.util.Arrays;
import java.util.Random;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.Interval;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Refit;

/**
 * How far the gap shrinks on rows that the fit never saw: each half of the blocks is predicted by
 * values that were fitted on the other half; a table of thresholds a sixth by the rest.
 *
 * @param before gap of each ping under the simulator as it is
 * @param after gap of each ping under the explanation
 * @param open the same before a set-up that has moved as far as its reference leaves open: what it
 *     is not known by shows there as scatter
 * @param fitted gap of each ping under the explanation as fitted on all of them
 */
public record GapGain(
    GapMeter.Gaps before, GapMeter.Gaps after, GapMeter.Gaps open, GapMeter.Gaps fitted) {
  /** A gap that is so many times what the simulator expects of itself is no matter of scatter. */
  private static final double MANY_TIMES = 2;

  /**
   * What was rightly named took away 2.6 % or more, an effect in two nones 0.3 and 0.6 %
   * (docs/method/measurements.md).
   */
  private static final double LEAST_SHRINKAGE = 0.01;

  private static final int RESAMPLES = 1000;
  private static final int EVALUATIONS = 20;

  /**
   * By how much wider, in logarithms, the spread between logs is than that between blocks of one:
   * root 2 for what chance does to the other log, the rest for its other poses and for fitted
   * values; measured on worlds of seeds 46 and 47 (docs/method/measurements.md).
   */
  private static final double OTHER_LOG = 2.1;

  /** Half of a log may lack whole sides of an obstacle, which a table cannot know then. */
  private static final int TABLE_PARTS = 6;

  /** Of a set-up that stays where it is, and an explanation that is the same on every half. */
  public GapGain(GapMeter.Gaps before, GapMeter.Gaps after) {
    this(before, after, after, after);
  }

  /** Measures. */
  public static GapGain of(CalibratedLog given, Blocks blocks, Hypothesis explanation) {
    GapMeter meter = new GapMeter(given);
    GapMeter.Gaps before = meter.measure(given, Hypothesis.NONE);
    if (explanation.size() == 0) {
      return new GapGain(before, before);
    }
    double[] observed = new double[given.log().size()];
    double[] expected = new double[observed.length];
    int parts = explanation.hasTable() ? TABLE_PARTS : 2;
    IntStream.range(0, parts)
        .parallel()
        .forEach(
            part -> {
              Fold left = blocks.part(part, parts);
              Refit rest = new Refit(given, ping -> !left.holds(ping));
              GapMeter.Gaps gaps = meter.measure(given, rest.of(explanation, EVALUATIONS));
              for (int i = 0; i < observed.length; i++) {
                if (left.holds(i)) {
                  observed[i] = gaps.observedM()[i];
                  expected[i] = gaps.expectedM()[i];
                }
              }
            });
    GapMeter.Gaps after = new GapMeter.Gaps(observed, expected);
    return new GapGain(before, after, after, meter.measure(given, explanation));
  }

  /** Returns the same beside what is left before a set-up that has moved. */
  public GapGain beside(GapMeter.Gaps moved) {
    return new GapGain(before, after, moved, fitted);
  }

  /**
   * Whether more than twice the scatter is left of what the set-up cannot take up. What is left
   * only where a half was not fitted does not count: half of the places do not say where an edge
   * is.
   */
  public boolean leavesMuch() {
    return isMuch(open) && isMuch(fitted);
  }

  private static boolean isMuch(GapMeter.Gaps gaps) {
    return mean(gaps.observedM()) > MANY_TIMES * mean(gaps.expectedM());
  }

  /** Whether the gap before is more than twice the scatter, whatever the set-up may take up. */
  public boolean isManyFloors() {
    return beforeM() > MANY_TIMES * floorM();
  }

  /**
   * Whether so much of the gap is gone that an explanation says something of it. What takes away
   * less may well be there, but the simulator does as well without.
   */
  public boolean isWorthNaming() {
    return afterM() <= (1 - LEAST_SHRINKAGE) * beforeM();
  }

  /** Returns the mean gap before, metres. */
  public double beforeM() {
    return mean(before.observedM());
  }

  /** Returns the mean gap after, metres. */
  public double afterM() {
    return mean(after.observedM());
  }

  /**
   * Returns the gap that a right model would leave, as the explanation itself expects before a
   * set-up that has moved, metres.
   */
  public double floorM() {
    return Math.min(afterM(), mean(open.expectedM()));
  }

  private static double mean(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value;
    }
    return values.length == 0 ? 0 : sum / values.length;
  }

  /** Returns by how much the gap shrinks, 1 - after / before; 0 where there is no gap before. */
  public double shrinkage() {
    return beforeM() > 0 ? 1 - afterM() / beforeM() : 0;
  }

  /**
   * Returns where the shrinkage of another log from the same set-up would lie 19 times of 20.
   * Blocks drawn with replacement give the spread of what is left, after / before, as a factor; it
   * is widened by {@link #OTHER_LOG}.
   *
   * @param blocks that are drawn
   * @param seed of the draws
   */
  public Interval shrinkage95(Blocks blocks, long seed) {
    double left = 1 - shrinkage();
    double[] drawn = resampled(blocks, seed);
    int tail = (int) (0.025 * RESAMPLES);
    return new Interval(
        1 - widened(left, drawn[RESAMPLES - 1 - tail]), 1 - widened(left, drawn[tail]));
  }

  private static double widened(double left, double end) {
    return left > 0 ? left * Math.pow(end / left, OTHER_LOG) : end;
  }

  /** What is left of the gap, after / before, of resampled logs, sorted. */
  private double[] resampled(Blocks blocks, long seed) {
    double[] beforeSums = sums(before.observedM(), blocks);
    double[] afterSums = sums(after.observedM(), blocks);
    Random random = new Random(seed);
    double[] left = new double[RESAMPLES];
    for (int draw = 0; draw < RESAMPLES; draw++) {
      double was = 0;
      double is = 0;
      for (int i = 0; i < beforeSums.length; i++) {
        int block = random.nextInt(beforeSums.length);
        was += beforeSums[block];
        is += afterSums[block];
      }
      left[draw] = was > 0 ? is / was : 1;
    }
    Arrays.sort(left);
    return left;
  }

  private static double[] sums(double[] values, Blocks blocks) {
    double[] sums = new double[blocks.count()];
    for (int i = 0; i < values.length; i++) {
      sums[blocks.of(i)] += values[i];
    }
    return sums;
  }
}
