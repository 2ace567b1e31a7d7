package simbad.experiments.run;

import java.util.OptionalDouble;
import simbad.sonar.frame.Angles;
import simbad.sonar.shape.ThresholdTable;

/** Where a trace crosses the bearings of a table since it found the edge. */
final class TraceCrossings {
  private TraceCrossings() {}

  /** Is told of each crossing. */
  @FunctionalInterface
  interface Visitor {
    void crossed(int bearing, double radiusM);
  }

  static void visit(Trace trace, ThresholdTable table, Visitor visitor) {
    for (int i = trace.firstOnEdge() + 1; i < trace.size(); i++) {
      visit(trace, i, table, visitor);
    }
  }

  /** The mean radius at each bearing in metres; empty where the trace never crossed it. */
  static OptionalDouble[] meanRadiusM(Trace trace, ThresholdTable table) {
    double[] sum = new double[table.size()];
    int[] crossings = new int[table.size()];
    visit(
        trace,
        table,
        (bearing, radiusM) -> {
          sum[bearing] += radiusM;
          crossings[bearing]++;
        });
    return means(sum, crossings);
  }

  static OptionalDouble[] means(double[] sum, int[] crossings) {
    OptionalDouble[] means = new OptionalDouble[sum.length];
    for (int k = 0; k < sum.length; k++) {
      means[k] =
          crossings[k] == 0 ? OptionalDouble.empty() : OptionalDouble.of(sum[k] / crossings[k]);
    }
    return means;
  }

  /** Every bearing that the way from the place before to this one crosses. */
  private static void visit(Trace trace, int place, ThresholdTable table, Visitor visitor) {
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
      visitor.crossed(index, radius);
    }
  }
}
