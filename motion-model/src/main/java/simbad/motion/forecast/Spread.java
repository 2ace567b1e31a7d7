package simbad.motion.forecast;

import java.util.Arrays;
import java.util.stream.IntStream;
import java.util.stream.Stream;
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
  /** Fewer windows make no class of their own. */
  private static final int LEAST_IN_CLASS = 60;

  private static final int MOST_CLASSES = 5;

  /** The share of values between the outermost quantiles. */
  private static final double INSIDE = 0.9;

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
   * Learns from residuals how those of another drive of the same robot lie. What a robot scatters
   * by differs from minute to minute and from drive to drive. So each half of the drive is foretold
   * by the other one, and all quantiles are wider, about their median, by as much as makes nine in
   * ten of what is foretold lie within the outermost; never narrower.
   *
   * @param exertions by window
   * @param residuals by window and component, in order of time
   */
  public static Spread ofAnother(double[] exertions, double[][] residuals) {
    Spread spread = of(exertions, residuals);
    int middle = exertions.length / 2;
    double[][] sizes =
        Stream.of(
                sizes(exertions, residuals, 0, middle),
                sizes(exertions, residuals, middle, exertions.length))
            .flatMap(Arrays::stream)
            .toArray(double[][]::new);
    double[][][] wider = new double[spread.quantiles.length][3][];
    for (int c = 0; c < 3; c++) {
      int component = c;
      double times = times(Arrays.stream(sizes).mapToDouble(size -> size[component]).toArray());
      for (int k = 0; k < wider.length; k++) {
        double[] own = spread.quantiles[k][c];
        double centre = own[PinballLoss.QUANTILES / 2];
        wider[k][c] = Arrays.stream(own).map(q -> centre + times * (q - centre)).toArray();
      }
    }
    return new Spread(spread.limits, wider);
  }

  /** How large residuals of a part are, in units of what all others foretell. */
  private static double[][] sizes(double[] exertions, double[][] residuals, int from, int to) {
    int[] others = IntStream.range(0, exertions.length).filter(i -> i < from || i >= to).toArray();
    Spread foretold =
        of(
            Arrays.stream(others).mapToDouble(i -> exertions[i]).toArray(),
            Arrays.stream(others).mapToObj(i -> residuals[i]).toArray(double[][]::new));
    double[][] sizes = new double[to - from][3];
    for (int i = from; i < to; i++) {
      for (int c = 0; c < 3; c++) {
        sizes[i - from][c] = size(foretold.at(exertions[i], c), residuals[i][c]);
      }
    }
    return sizes;
  }

  /** How far a residual is from the median, over how far the outermost quantile is. */
  private static double size(double[] quantiles, double residual) {
    double off = residual - quantiles[PinballLoss.QUANTILES / 2];
    double reach =
        quantiles[off < 0 ? 0 : PinballLoss.QUANTILES - 1] - quantiles[PinballLoss.QUANTILES / 2];
    return reach == 0 ? 0 : off / reach;
  }

  /** What nine in ten sizes do not exceed; at least 1. */
  private static double times(double[] sizes) {
    double[] sorted = sizes.clone();
    Arrays.sort(sorted);
    return sorted.length == 0 ? 1 : Math.max(1, sorted[(int) (INSIDE * (sorted.length - 1))]);
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
    double[] quantiles = new double[PinballLoss.QUANTILES];
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    for (int q = 0; q < PinballLoss.QUANTILES && sorted.length > 0; q++) {
      // As of an exchangeable next value: its rank is as likely below the first as between two.
      double at =
          Math.max(0, Math.min(sorted.length - 1, PinballLoss.level(q) * (sorted.length + 1) - 1));
      int low = (int) at;
      int high = Math.min(low + 1, sorted.length - 1);
      quantiles[q] = sorted[low] + (at - low) * (sorted[high] - sorted[low]);
    }
    return quantiles;
  }
}
