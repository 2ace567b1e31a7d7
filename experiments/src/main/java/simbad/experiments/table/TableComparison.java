package simbad.experiments.table;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleBiFunction;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import simbad.gap.diagnosis.Interval;
import simbad.sonar.check.Checks;
import simbad.sonar.shape.ThresholdTable;

/**
 * How alike two threshold tables are, bearing by bearing, as they stand and at their best.
 *
 * <p>Thresholds span decades, so that the correlation is that of their logarithms, and errors are
 * ratios. Below {@value #LEAST_M} m all thresholds count as that: no bench sets less.
 *
 * @param bearings of the first table, at which the second one is read off (between its own bearings
 *     on the straight edges of its shadow)
 * @param correlation of the logarithms, in [-1, 1]; 0 when one table is a circle
 * @param medianRatioError median over the bearings of the greater over the lesser threshold, less 1
 * @param meanDifferenceM mean of second less first, metres
 * @param meanAbsoluteDifferenceM mean of the differences' sizes, metres
 * @param best rotation and mirror of the second table that correlate best
 */
public record TableComparison(
    List<Row> bearings,
    double correlation,
    double medianRatioError,
    double meanDifferenceM,
    double meanAbsoluteDifferenceM,
    Placement best) {
  /** What is nearer counts as this near, metres. */
  public static final double LEAST_M = 0.01;

  /** Neighbours that are resampled together, degrees: a transducer hears about as wide. */
  public static final double BLOCK_DEG = 20;

  private static final double TURN_DEG = 360;

  private static final int RESAMPLES = 2000;

  /**
   * One bearing.
   *
   * @param bearingDeg degrees
   * @param firstM threshold in the first table, metres
   * @param secondM threshold in the second
   */
  public record Row(double bearingDeg, double firstM, double secondM) {
    /** Checks that all are finite. */
    public Row {
      Checks.finite("bearingDeg", bearingDeg);
      Checks.finite("firstM", firstM);
      Checks.finite("secondM", secondM);
    }

    /** Returns second less first in metres. */
    public double differenceM() {
      return secondM - firstM;
    }
  }

  /**
   * How the second table has to be laid over the first.
   *
   * @param rotationDeg by which its bearings grow, in (-180, 180], a multiple of the first table's
   *     spacing
   * @param mirrored whether bearing b is taken from -b before
   * @param correlation of the logarithms then
   */
  public record Placement(double rotationDeg, boolean mirrored, double correlation) {
    /** Checks the angle and the correlation. */
    public Placement {
      Checks.finite("rotationDeg", rotationDeg);
      Checks.number("correlation", correlation);
    }
  }

  /** Checks that all are numbers and copies the list. */
  public TableComparison {
    Checks.number("correlation", correlation);
    Checks.number("medianRatioError", medianRatioError);
    Checks.number("meanDifferenceM", meanDifferenceM);
    Checks.number("meanAbsoluteDifferenceM", meanAbsoluteDifferenceM);
    bearings = List.copyOf(bearings);
  }

  /**
   * Compares two tables.
   *
   * @param first whose bearings are used
   * @param second any number of bearings
   */
  public static TableComparison of(ThresholdTable first, ThresholdTable second) {
    int n = first.size();
    double[] a = first.valuesM();
    double[] b =
        IntStream.range(0, n).mapToDouble(i -> second.thresholdM(first.bearingRad(i))).toArray();
    List<Row> rows = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      rows.add(new Row(i * TURN_DEG / n, a[i], b[i]));
    }
    return new TableComparison(
        rows,
        correlation(a, b),
        medianRatioError(a, b),
        rows.stream().mapToDouble(Row::differenceM).average().orElseThrow(),
        rows.stream().mapToDouble(row -> Math.abs(row.differenceM())).average().orElseThrow(),
        best(a, b));
  }

  /**
   * Returns the 95 % interval of {@link #correlation}: resampled by runs of {@value #BLOCK_DEG}
   * degrees round the circle, since neighbouring bearings are not independent (percentiles of the
   * circular block bootstrap, Politis and Romano 1992). It tells what other bearings of the same
   * obstacle would make of the figure, not what another obstacle would.
   *
   * @param random the same state gives the same interval
   */
  public Interval correlationInterval(RandomGenerator random) {
    return interval(TableComparison::correlation, random);
  }

  /**
   * Returns the 95 % interval of {@link #medianRatioError}, as that of the correlation.
   *
   * @param random the same state gives the same interval
   */
  public Interval medianRatioInterval(RandomGenerator random) {
    return interval(TableComparison::medianRatioError, random);
  }

  private Interval interval(
      ToDoubleBiFunction<double[], double[]> statistic, RandomGenerator random) {
    int n = bearings.size();
    int block = Math.max(1, (int) Math.round(BLOCK_DEG * n / TURN_DEG));
    double[] drawn = new double[RESAMPLES];
    double[] a = new double[n];
    double[] b = new double[n];
    for (int k = 0; k < RESAMPLES; k++) {
      for (int i = 0, from = 0; i < n; i++, from++) {
        if (i % block == 0) {
          from = random.nextInt(n);
        }
        Row row = bearings.get(from % n);
        a[i] = row.firstM();
        b[i] = row.secondM();
      }
      drawn[k] = statistic.applyAsDouble(a, b);
    }
    Arrays.sort(drawn);
    int tail = RESAMPLES / 40;
    return new Interval(drawn[tail - 1], drawn[RESAMPLES - tail]);
  }

  private static Placement best(double[] a, double[] b) {
    int n = a.length;
    Placement best = new Placement(0, false, correlation(a, b));
    for (boolean mirrored : new boolean[] {false, true}) {
      for (int turn = 0; turn < n; turn++) {
        double[] laid = new double[n];
        for (int i = 0; i < n; i++) {
          int from = Math.floorMod(i - turn, n);
          laid[i] = b[mirrored ? (n - from) % n : from];
        }
        double correlation = correlation(a, laid);
        // A tie, as of a symmetric table with its mirror image, goes to what was tried first.
        if (correlation > best.correlation() + 1e-12) {
          double degrees = turn * TURN_DEG / n;
          best =
              new Placement(
                  degrees > TURN_DEG / 2 ? degrees - TURN_DEG : degrees, mirrored, correlation);
        }
      }
    }
    return best;
  }

  private static double correlation(double[] a, double[] b) {
    double[] x = logs(a);
    double[] y = logs(b);
    double xx = 0;
    double yy = 0;
    double xy = 0;
    for (int i = 0; i < x.length; i++) {
      xx += x[i] * x[i];
      yy += y[i] * y[i];
      xy += x[i] * y[i];
    }
    // Of a circle nothing but rounding is left.
    return xx < 1e-20 || yy < 1e-20 ? 0 : xy / Math.sqrt(xx * yy);
  }

  /** Logarithms less their mean. */
  private static double[] logs(double[] thresholds) {
    double[] logs = Arrays.stream(thresholds).map(t -> Math.log(Math.max(t, LEAST_M))).toArray();
    double mean = Arrays.stream(logs).average().orElseThrow();
    return Arrays.stream(logs).map(value -> value - mean).toArray();
  }

  private static double medianRatioError(double[] a, double[] b) {
    double[] sorted =
        IntStream.range(0, a.length)
            .mapToDouble(i -> Math.abs(Math.log(Math.max(a[i], LEAST_M) / Math.max(b[i], LEAST_M))))
            .sorted()
            .toArray();
    return Math.expm1((sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2);
  }
}
