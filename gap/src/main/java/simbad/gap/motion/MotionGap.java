package simbad.gap.motion;

import java.util.Arrays;
import java.util.List;
import org.hipparchus.special.Erf;
import simbad.gap.diagnosis.Interval;
import simbad.motion.MotionChain;
import simbad.motion.Robot;

/**
 * The gap of motion: continuous ranked probability scores by 19 quantiles, over blocks that were
 * not fitted, for each horizon and component.
 *
 * @param before nominal, by horizon and component, metres and radians
 * @param after diagnosed
 * @param ratio the gap after: the mean of the nine, each in units of its nominal value
 * @param ci95 of the ratio, by leaving out one twentieth of the blocks at a time
 * @param windows of half a second that were scored
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers by window, never compared.
record MotionGap(double[][] before, double[][] after, double ratio, Interval ci95, int windows) {
  static final int QUANTILES = 19;
  private static final int GROUPS = 20;

  static MotionGap of(Evidence shortest, Robot robot, MotionChain base, List<Fit> folds) {
    Sums sums = new Sums();
    for (int h = 0; h < Windows.HORIZONS_S.length; h++) {
      Evidence evidence = h == 0 ? shortest : new Evidence(shortest.runs(), Windows.HORIZONS_S[h]);
      double[][] nominal = evidence.residuals(base);
      for (int fold = 0; fold < folds.size(); fold++) {
        double[][] diagnosed = evidence.residuals(folds.get(fold).hypothesis().chain());
        for (int c = 0; c < 3; c++) {
          double[] spread = empirical(evidence, diagnosed, fold, c);
          double[] believed = believed(robot, c);
          for (int i = 0; i < diagnosed.length; i++) {
            if (evidence.fold(i) == fold) {
              int group = evidence.block(i) % GROUPS;
              sums.add(group, h, c, score(believed, nominal[i][c]), score(spread, diagnosed[i][c]));
            }
          }
        }
      }
    }
    return sums.gap(shortest.size());
  }

  /** The residuals' quantiles where the fold was fitted. */
  private static double[] empirical(Evidence evidence, double[][] residuals, int fold, int c) {
    double[] values = new double[residuals.length];
    int n = 0;
    for (int i = 0; i < values.length; i++) {
      if (evidence.fold(i) != fold) {
        values[n++] = residuals[i][c];
      }
    }
    return quantiles(Arrays.copyOf(values, n));
  }

  /** Returns the quantiles q05 to q95 of numbers; zeros where there are none. */
  static double[] quantiles(double[] values) {
    double[] quantiles = new double[QUANTILES];
    Arrays.sort(values);
    for (int q = 0; q < QUANTILES && values.length > 0; q++) {
      double at = (q + 1) * 0.05 * (values.length - 1);
      int low = (int) at;
      int high = Math.min(low + 1, values.length - 1);
      quantiles[q] = values[low] + (at - low) * (values[high] - values[low]);
    }
    return quantiles;
  }

  /** What the tracker alone scatters, at both ends of a window. */
  static double[] believed(Robot robot, int component) {
    double sigma = component == 2 ? robot.trackSigmaRad() : robot.trackSigmaM();
    double[] quantiles = new double[QUANTILES];
    for (int q = 0; q < QUANTILES; q++) {
      quantiles[q] = 2 * sigma * Erf.erfInv(2 * (q + 1) * 0.05 - 1);
    }
    return quantiles;
  }

  /** Twice the mean pinball loss. */
  private static double score(double[] quantiles, double value) {
    double sum = 0;
    for (int q = 0; q < QUANTILES; q++) {
      double level = (q + 1) * 0.05;
      double off = value - quantiles[q];
      sum += off >= 0 ? level * off : (level - 1) * off;
    }
    return 2 * sum / QUANTILES;
  }

  /** Sums of scores by group of blocks, so that any group can be left out. */
  private static final class Sums {
    private final double[][][] before = new double[GROUPS][3][3];
    private final double[][][] after = new double[GROUPS][3][3];
    private final int[][][] counts = new int[GROUPS][3][3];

    void add(int group, int horizon, int component, double nominal, double diagnosed) {
      before[group][horizon][component] += nominal;
      after[group][horizon][component] += diagnosed;
      counts[group][horizon][component]++;
    }

    MotionGap gap(int windows) {
      double ratio = ratio(-1);
      double square = 0;
      for (int group = 0; group < GROUPS; group++) {
        double off = ratio(group) - ratio;
        square += off * off * (GROUPS - 1) / GROUPS;
      }
      double half = 1.96 * Math.sqrt(square);
      return new MotionGap(
          means(before), means(after), ratio, new Interval(ratio - half, ratio + half), windows);
    }

    private double ratio(int leftOut) {
      double sum = 0;
      int parts = 0;
      for (int h = 0; h < 3; h++) {
        for (int c = 0; c < 3; c++) {
          double nominal = 0;
          double diagnosed = 0;
          for (int group = 0; group < GROUPS; group++) {
            nominal += group == leftOut ? 0 : before[group][h][c];
            diagnosed += group == leftOut ? 0 : after[group][h][c];
          }
          if (nominal > 0) {
            sum += diagnosed / nominal;
            parts++;
          }
        }
      }
      return parts == 0 ? 1 : sum / parts;
    }

    private double[][] means(double[][][] sums) {
      double[][] means = new double[3][3];
      for (int h = 0; h < 3; h++) {
        for (int c = 0; c < 3; c++) {
          double sum = 0;
          int count = 0;
          for (int group = 0; group < GROUPS; group++) {
            sum += sums[group][h][c];
            count += counts[group][h][c];
          }
          means[h][c] = count == 0 ? 0 : sum / count;
        }
      }
      return means;
    }
  }
}
