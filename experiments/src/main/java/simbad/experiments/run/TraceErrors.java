package simbad.experiments.run;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import simbad.sonar.frame.Angles;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * How far a trace is from a table.
 *
 * <p>Radial: per bearing of the table, the mean of |r - T| over all crossings of that bearing since
 * the edge was found. Lateral: the distance of each place since then from the shadow's edge.
 *
 * @param radialM per bearing of the table, metres; empty where the trace never crossed it
 * @param lateralMeanM mean, metres; 0 if the edge was never found
 * @param lateralP95M 95 % quantile, metres
 * @param lateralMaxM greatest, metres
 */
public record TraceErrors(
    List<OptionalDouble> radialM, double lateralMeanM, double lateralP95M, double lateralMaxM) {

  private static final double SHARE_OF_P95 = 0.95;

  /** Copies the list. */
  public TraceErrors {
    radialM = List.copyOf(radialM);
  }

  /** Compares a trace with a table. */
  static TraceErrors of(Trace trace, ThresholdTable table) {
    double[] sum = new double[table.size()];
    int[] crossings = new int[table.size()];
    for (int i = trace.firstOnEdge() + 1; i < trace.size(); i++) {
      addCrossings(trace, i, table, sum, crossings);
    }
    OptionalDouble[] radial = new OptionalDouble[table.size()];
    for (int k = 0; k < radial.length; k++) {
      radial[k] =
          crossings[k] == 0 ? OptionalDouble.empty() : OptionalDouble.of(sum[k] / crossings[k]);
    }
    double[] lateral = lateral(trace, table);
    return new TraceErrors(
        Arrays.asList(radial),
        Arrays.stream(lateral).average().orElse(0),
        lateral.length == 0 ? 0 : lateral[(int) (SHARE_OF_P95 * (lateral.length - 1))],
        lateral.length == 0 ? 0 : lateral[lateral.length - 1]);
  }

  /** Every bearing that the way from the place before to this one crosses. */
  private static void addCrossings(
      Trace trace, int place, ThresholdTable table, double[] sum, int[] crossings) {
    double fromX = trace.xM(place - 1);
    double fromZ = trace.zM(place - 1);
    double toX = trace.xM(place);
    double toZ = trace.zM(place);
    double from = Angles.positive(Math.atan2(fromX, fromZ));
    double to = Angles.positive(Math.atan2(toX, toZ));
    boolean rising = Angles.signed(to - from) >= 0;
    // Whole cells, each from its place alone: the way that ends at a place and the way that begins
    // there agree on which side of a bearing it lies, so that each crossing is counted once.
    int first = (int) ((rising ? from : to) / table.spacingRad());
    int last = (int) ((rising ? to : from) / table.spacingRad());
    last += last < first ? table.size() : 0;
    for (int k = first + 1; k <= last; k++) {
      int index = Math.floorMod(k, table.size());
      double sin = Math.sin(table.bearingRad(index));
      double cos = Math.cos(table.bearingRad(index));
      double before = fromX * cos - fromZ * sin;
      double after = toX * cos - toZ * sin;
      double share = before == after ? 0 : before / (before - after);
      double radius = Math.hypot(fromX + share * (toX - fromX), fromZ + share * (toZ - fromZ));
      sum[index] += Math.abs(radius - table.valueM(index));
      crossings[index]++;
    }
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
