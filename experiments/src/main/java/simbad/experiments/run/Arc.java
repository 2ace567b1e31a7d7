package simbad.experiments.run;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.check.Checks;

/**
 * A piece of a shadow's edge, in the sense of rising bearings.
 *
 * @param fromRad bearing at which it begins, in [0, 2 pi)
 * @param toRad bearing at which it ends, in [0, 2 pi); below the former where it goes across 0
 * @param lengthM of the edge in it, metres
 */
public record Arc(double fromRad, double toRad, double lengthM) {
  /** Checks that all are finite. */
  public Arc {
    Checks.finite("fromRad", fromRad);
    Checks.finite("toRad", toRad);
    Checks.notNegative("lengthM", lengthM);
  }

  /** The whole runs of pieces that are not near the trace, in the order of their bearings. */
  static List<Arc> far(List<EdgePiece> pieces, double[] distanceM) {
    int count = pieces.size();
    int first = 0;
    while (first < count && distanceM[first] > EdgeKept.NEAR_M) {
      first++;
    }
    if (first == count) {
      double wholeM = pieces.stream().mapToDouble(EdgePiece::lengthM).sum();
      return List.of(new Arc(0, 0, wholeM));
    }
    // Begun at a piece that is near, no run goes across the end of the list.
    List<Integer> order = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      order.add((first + i) % count);
    }
    List<Arc> arcs = new ArrayList<>();
    List<EdgePiece> run = new ArrayList<>();
    for (int i : order) {
      if (distanceM[i] > EdgeKept.NEAR_M) {
        run.add(pieces.get(i));
      } else if (!run.isEmpty()) {
        arcs.add(of(run));
        run.clear();
      }
    }
    if (!run.isEmpty()) {
      arcs.add(of(run));
    }
    return arcs;
  }

  private static Arc of(List<EdgePiece> run) {
    return new Arc(
        run.get(0).bearingRad(),
        run.get(run.size() - 1).bearingRad(),
        run.stream().mapToDouble(EdgePiece::lengthM).sum());
  }
}
