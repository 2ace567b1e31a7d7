package simbad.experiments.run;

import java.util.ArrayList;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.shape.Outline;

/** A short straight piece of a shadow's edge, by its middle; metres. */
record EdgePiece(double xM, double zM, double lengthM) {
  /** A tenth of what counts as near, so that the share of the edge is fine enough. */
  private static final double LONGEST_M = 0.1 * EdgeKept.NEAR_M;

  /** Of an edge of kilometres the pieces are longer. */
  private static final double MOST = 100_000;

  /** Cuts an edge into pieces, in the order of its corners. */
  static List<EdgePiece> cut(Outline edge) {
    List<EdgePiece> pieces = new ArrayList<>();
    double longestM = Math.max(LONGEST_M, edge.perimeterM() / MOST);
    for (int i = 0; i < edge.size(); i++) {
      int next = (i + 1) % edge.size();
      double alongX = edge.xM(next) - edge.xM(i);
      double alongZ = edge.zM(next) - edge.zM(i);
      double lengthM = Math.hypot(alongX, alongZ);
      int count = (int) Math.ceil(lengthM / longestM);
      for (int k = 0; k < count; k++) {
        double share = (k + 0.5) / count;
        pieces.add(
            new EdgePiece(
                edge.xM(i) + share * alongX, edge.zM(i) + share * alongZ, lengthM / count));
      }
    }
    return pieces;
  }

  /** From the obstacle's centre, radians in [0, 2 pi). */
  double bearingRad() {
    return Angles.positive(Math.atan2(xM, zM));
  }
}
