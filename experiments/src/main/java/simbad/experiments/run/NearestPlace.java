package simbad.experiments.run;

/** Finds the place of a trace, since it found the edge, that is nearest to a point. */
final class NearestPlace {
  private final Trace trace;
  private final double longestStepM;
  private int nearest;

  NearestPlace(Trace trace) {
    this.trace = trace;
    nearest = trace.firstOnEdge();
    double longest = Double.MIN_NORMAL;
    for (int i = nearest + 1; i < trace.size(); i++) {
      longest =
          Math.max(
              longest, Math.hypot(trace.xM(i) - trace.xM(i - 1), trace.zM(i) - trace.zM(i - 1)));
    }
    longestStepM = longest;
  }

  /** In metres; infinite if the robot never found the edge. */
  double distanceM(double xM, double zM) {
    if (trace.firstOnEdge() == trace.size()) {
      return Double.POSITIVE_INFINITY;
    }
    // Points that are asked for one after the other lie beside each other.
    double best = toPlaceM(nearest, xM, zM);
    int i = trace.firstOnEdge();
    while (i < trace.size()) {
      double distance = toPlaceM(i, xM, zM);
      if (distance < best) {
        best = distance;
        nearest = i;
      }
      // A place that is farther by so many steps cannot be followed sooner by a nearer one.
      i += (int) Math.max(1, Math.min(trace.size(), (distance - best) / longestStepM));
    }
    return best;
  }

  private double toPlaceM(int place, double xM, double zM) {
    double asideX = trace.xM(place) - xM;
    double asideZ = trace.zM(place) - zM;
    return Math.sqrt(asideX * asideX + asideZ * asideZ);
  }
}
