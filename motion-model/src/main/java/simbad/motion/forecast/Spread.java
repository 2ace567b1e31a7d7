package simbad.motion.forecast;

import java.util.Arrays;
import java.util.stream.IntStream;
import simbad.sonar.check.Checks;

/**
 * How displacements of one horizon lie about what a chain expects: the 19 quantiles q05 to q95 of
 * each component, by how much is asked of the robot.
 *
 * @param limits of exertion between the classes, ascending; one class more than limits
 * @param quantiles by class and component, metres and radians, each ascending
 */
@SuppressWarnings("ArrayRecordComponent") // Numbers, never compared.
public record Spread(double[] limits, double[][][] quantiles) {
  /** So many quantiles make a forecast. */
  public static final int QUANTILES = 19;

  /** Fewer windows make no class of their own. */
  private static final int LEAST_IN_CLASS = 60;

  private static final int MOST_CLASSES = 5;

  /** Checks that all are numbers, and that there is a class between all limits. */
  public Spread {
    Checks.numbers("limits", limits);
    for (double[][] ofClass : quantiles) {
      Checks.numbers("quantiles", ofClass);
    }
    if (quantiles.length != limits.length + 1) {
      throw new IllegalArgumentException(
          quantiles.length + " classes do not fit " + limits.length + " limits");
    }
  }

  /** Returns the level of a quantile, in (0, 1). */
  public static double level(int quantile) {
    return (quantile + 1) * 0.05;
  }

  /** Returns a spread with one class. */
  public static Spread one(double[][] quantiles) {
    return new Spread(new double[0], new double[][][] {quantiles});
  }

  /**
   * Learns from residuals.
   *
   * @param exertions by window
   * @param residuals by window and component
   */
  public static Spread of(double[] exertions, double[][] residuals) {
    Checks.numbers("exertions", exertions);
    Checks.numbers("residuals", residuals);
    double[] sorted = exertions.clone();
    Arrays.sort(sorted);
    int classes = Math.max(1, Math.min(MOST_CLASSES, sorted.length / LEAST_IN_CLASS));
    double[] limits = new double[classes - 1];
    for (int i = 0; i < limits.length; i++) {
      limits[i] = sorted[(int) ((i + 1L) * sorted.length / classes)];
    }
    double[][][] quantiles = new double[classes][3][];
    for (int k = 0; k < classes; k++) {
      int[] members = members(exertions, limits, k);
      for (int c = 0; c < 3; c++) {
        int component = c;
        quantiles[k][c] =
            quantiles(Arrays.stream(members).mapToDouble(i -> residuals[i][component]).toArray());
      }
    }
    return new Spread(limits, quantiles);
  }

  /**
   * Learns from residuals how those of another drive of the same length lie. Of each class and
   * component the means of a drive's parts say how well the mean of all is known; the mean of
   * another drive is off by as much again. So the quantiles are wider, about their median, as if
   * that were added to each residual.
   *
   * @param exertions by window
   * @param residuals by window and component, in order of time
   * @param parts that a drive is cut into, at least 2
   */
  public static Spread ofAnother(double[] exertions, double[][] residuals, int parts) {
    Checks.atLeast("parts", parts, 2);
    Spread spread = of(exertions, residuals);
    double[][][] wider = new double[spread.quantiles.length][3][];
    for (int k = 0; k < wider.length; k++) {
      int[] members = members(exertions, spread.limits, k);
      for (int c = 0; c < 3; c++) {
        double times = times(members, residuals, c, parts);
        double[] own = spread.quantiles[k][c];
        double middle = own[QUANTILES / 2];
        wider[k][c] = Arrays.stream(own).map(q -> middle + times * (q - middle)).toArray();
      }
    }
    return new Spread(spread.limits, wider);
  }

  /** By how many times residuals scatter more with the mean of another drive. */
  private static double times(int[] members, double[][] residuals, int component, int parts) {
    double mean =
        Arrays.stream(members).mapToDouble(i -> residuals[i][component]).average().orElse(0);
    double[] sums = new double[parts];
    double square = 0;
    for (int i : members) {
      double off = residuals[i][component] - mean;
      sums[(int) ((long) i * parts / residuals.length)] += off;
      square += off * off;
    }
    double ofSum = Arrays.stream(sums).map(sum -> sum * sum).sum() * parts / (parts - 1.0);
    return square > 0 ? Math.sqrt(1 + 2 * ofSum / members.length / square) : 1;
  }

  private static int[] members(double[] exertions, double[] limits, int klass) {
    return IntStream.range(0, exertions.length)
        .filter(i -> index(limits, exertions[i]) == klass)
        .toArray();
  }

  private static int index(double[] limits, double exertion) {
    int index = 0;
    while (index < limits.length && exertion >= limits[index]) {
      index++;
    }
    return index;
  }

  /** Returns the quantiles of a component for a window in which so much is asked. */
  public double[] at(double exertion, int component) {
    return quantiles[index(limits, exertion)][component];
  }

  /** Returns the quantiles q05 to q95 of numbers; zeros where there are none. */
  public static double[] quantiles(double[] values) {
    double[] quantiles = new double[QUANTILES];
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    for (int q = 0; q < QUANTILES && sorted.length > 0; q++) {
      // As of an exchangeable next value: its rank is as likely below the first as between two.
      double at = Math.max(0, Math.min(sorted.length - 1, level(q) * (sorted.length + 1) - 1));
      int low = (int) at;
      int high = Math.min(low + 1, sorted.length - 1);
      quantiles[q] = sorted[low] + (at - low) * (sorted[high] - sorted[low]);
    }
    return quantiles;
  }

  /**
   * Returns the CRPS by quantiles: twice the mean {@link PinballLoss}.
   *
   * @param quantiles of what was expected
   * @param residual the value
   */
  public static double score(double[] quantiles, double residual) {
    double sum = 0;
    for (int q = 0; q < QUANTILES; q++) {
      double off = residual - quantiles[q];
      sum += PinballLoss.of(level(q), off);
    }
    return 2 * sum / QUANTILES;
  }
}
