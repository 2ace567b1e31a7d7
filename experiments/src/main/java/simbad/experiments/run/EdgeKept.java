package simbad.experiments.run;

import java.util.List;
import java.util.OptionalDouble;
import simbad.sonar.check.Checks;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * How much of a shadow's edge a trace kept: the other way round than lateral errors, which only say
 * how far the trace is from the edge, and are small where a whole lobe was cut off.
 *
 * @param share of the edge's length that has a place of the trace within {@value #NEAR_M} m, in [0,
 *     1]; 0 if the robot never found the edge, empty if the table has none
 * @param meanM mean distance from the edge to the trace, by length, metres; empty if there is no
 *     edge, or the robot never found it
 * @param maxM greatest distance from the edge to the trace, metres; likewise
 * @param skipped the pieces of the edge that have no place of the trace so near, by bearing
 */
public record EdgeKept(
    OptionalDouble share, OptionalDouble meanM, OptionalDouble maxM, List<Arc> skipped) {

  /** A place of the trace that is so near has kept that piece of the edge. */
  public static final double NEAR_M = 0.05;

  /** A robot that kept less than this share of an edge did not keep it. */
  public static final double LEAST_SHARE = 0.95;

  /** Checks the figures and copies the list. */
  public EdgeKept {
    share.ifPresent(kept -> Checks.share("share", kept));
    meanM.ifPresent(mean -> Checks.notNegative("meanM", mean));
    maxM.ifPresent(most -> Checks.notNegative("maxM", most));
    skipped = List.copyOf(skipped);
  }

  /** Compares an edge with the places of a trace since the robot found it. */
  static EdgeKept of(Trace trace, ThresholdTable table) {
    if (table.greatestM() == 0) {
      return new EdgeKept(
          OptionalDouble.empty(), OptionalDouble.empty(), OptionalDouble.empty(), List.of());
    }
    List<EdgePiece> pieces = EdgePiece.cut(Outline.of(table.points()));
    NearestPlace places = new NearestPlace(trace);
    double[] distanceM =
        pieces.stream().mapToDouble(at -> places.distanceM(at.xM(), at.zM())).toArray();
    double wholeM = 0;
    double keptM = 0;
    double sum = 0;
    double maxM = 0;
    for (int i = 0; i < distanceM.length; i++) {
      double lengthM = pieces.get(i).lengthM();
      wholeM += lengthM;
      keptM += distanceM[i] <= NEAR_M ? lengthM : 0;
      sum += lengthM * distanceM[i];
      maxM = Math.max(maxM, distanceM[i]);
    }
    boolean found = trace.firstOnEdge() < trace.size();
    return new EdgeKept(
        OptionalDouble.of(keptM / wholeM),
        found ? OptionalDouble.of(sum / wholeM) : OptionalDouble.empty(),
        found ? OptionalDouble.of(maxM) : OptionalDouble.empty(),
        Arc.far(pieces, distanceM));
  }

  /** Tells whether less of the edge was kept than {@link #LEAST_SHARE}. */
  public boolean isLost() {
    return share.isPresent() && share.getAsDouble() < LEAST_SHARE;
  }
}
