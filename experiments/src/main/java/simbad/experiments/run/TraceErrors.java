package simbad.experiments.run;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import simbad.sonar.check.Checks;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * How far a trace is from a table.
 *
 * <p>Radial: per bearing of the table, the mean of |r - T| over all crossings of that bearing since
 * the edge was found. Lateral: the distance of each place since then from the shadow's edge.
 * Neither sees a lobe that was cut off, whose bearings were crossed elsewhere: how much of the edge
 * was kept does.
 *
 * @param radialM per bearing of the table, metres; empty where the trace never crossed it
 * @param lateralMeanM mean, metres; 0 if the edge was never found
 * @param lateralP95M 95 % quantile, metres
 * @param lateralMaxM greatest, metres
 * @param edge how much of it the trace kept
 */
public record TraceErrors(
    List<OptionalDouble> radialM,
    double lateralMeanM,
    double lateralP95M,
    double lateralMaxM,
    EdgeKept edge) {

  private static final double SHARE_OF_P95 = 0.95;

  /** Checks the figures and copies the list. */
  public TraceErrors {
    Checks.notNegative("lateralMeanM", lateralMeanM);
    Checks.notNegative("lateralP95M", lateralP95M);
    Checks.notNegative("lateralMaxM", lateralMaxM);
    radialM = List.copyOf(radialM);
  }

  /** Compares a trace with a table. */
  static TraceErrors of(Trace trace, ThresholdTable table) {
    double[] sum = new double[table.size()];
    int[] crossings = new int[table.size()];
    TraceCrossings.visit(
        trace,
        table,
        (bearing, radiusM) -> {
          sum[bearing] += Math.abs(radiusM - table.valueM(bearing));
          crossings[bearing]++;
        });
    double[] lateral = lateral(trace, table);
    return new TraceErrors(
        Arrays.asList(TraceCrossings.means(sum, crossings)),
        Arrays.stream(lateral).average().orElse(0),
        lateral.length == 0 ? 0 : lateral[(int) (SHARE_OF_P95 * (lateral.length - 1))],
        lateral.length == 0 ? 0 : lateral[lateral.length - 1],
        EdgeKept.of(trace, table));
  }

  private static double[] lateral(Trace trace, ThresholdTable table) {
    if (trace.firstOnEdge() == trace.size() || table.greatestM() == 0) {
      return new double[0];
    }
    Outline edge = Outline.of(table.points());
    double[] lateral = new double[trace.size() - trace.firstOnEdge()];
    for (int i = 0; i < lateral.length; i++) {
      int place = trace.firstOnEdge() + i;
      lateral[i] = edge.distanceM(trace.xM(place), trace.zM(place));
    }
    Arrays.sort(lateral);
    return lateral;
  }

  private DoubleStream reached() {
    return radialM.stream()
        .filter(OptionalDouble::isPresent)
        .mapToDouble(OptionalDouble::getAsDouble);
  }

  /** Returns the mean over the bearings that were crossed, metres; none if none was. */
  public OptionalDouble meanM() {
    return reached().average();
  }

  /** Returns the root of the mean square over the bearings that were crossed, metres. */
  public OptionalDouble rmsM() {
    OptionalDouble meanSquare = reached().map(error -> error * error).average();
    return meanSquare.isPresent()
        ? OptionalDouble.of(Math.sqrt(meanSquare.getAsDouble()))
        : meanSquare;
  }

  /** Returns the greatest over the bearings that were crossed, metres. */
  public OptionalDouble maxM() {
    return reached().max();
  }

  /** Returns the median over the bearings that were crossed, metres. */
  public OptionalDouble medianM() {
    double[] sorted = reached().sorted().toArray();
    int middle = sorted.length / 2;
    if (sorted.length == 0) {
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(
        sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2);
  }

  /** Returns how many bearings were never crossed. */
  public int unreachedBearings() {
    return radialM.size() - (int) reached().count();
  }
}
