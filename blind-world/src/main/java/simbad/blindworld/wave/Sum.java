package simbad.blindworld.wave;

/** Adds elements of an outline to a trace. */
final class Sum {

  private static final double FAINTEST = 1e-5;

  private final Trace trace;
  private final Medium medium;
  private final VerticalSum vertical;

  Sum(Trace trace, Medium medium, VerticalSum vertical) {
    this.trace = trace;
    this.medium = medium;
    this.vertical = vertical;
  }

  /** Every element that both see. */
  void add(Outline outline, Listener out, Listener in) {
    boolean hollow = !outline.faces.isEmpty();
    for (int e = 0; e < outline.size(); e++) {
      if (cosine(outline, e, out) > 0
          && cosine(outline, e, in) > 0
          && (!hollow || isFree(outline, e, out, in))) {
        element(outline, e, out, in);
      }
    }
  }

  private static boolean isFree(Outline outline, int e, Listener out, Listener in) {
    return outline.isFree(e, out.xM(), out.zM()) && outline.isFree(e, in.xM(), in.zM());
  }

  /** Every element that the one behind a mirror sees through it, and the other directly. */
  void addBy(Outline.Face mirror, Outline outline, Listener behind, Listener in) {
    for (int e = 0; e < outline.size(); e++) {
      if (cosine(outline, e, behind) > 0
          && cosine(outline, e, in) > 0
          && mirror.parts(behind.xM(), behind.zM(), outline.xM[e], outline.zM[e])
          && outline.isFree(e, in.xM(), in.zM())) {
        element(outline, e, behind, in);
      }
    }
  }

  private static double cosine(Outline outline, int e, Listener listener) {
    double dx = listener.xM() - outline.xM[e];
    double dz = listener.zM() - outline.zM[e];
    return (dx * outline.normalX[e] + dz * outline.normalZ[e])
        / listener.distanceTo(outline.xM[e], outline.zM[e]);
  }

  /** The Kirchhoff integrand, turned so that a wall's echo is in phase with its mirror image. */
  private void element(Outline outline, int e, Listener out, Listener in) {
    double x = outline.xM[e];
    double z = outline.zM[e];
    double aim = medium.sent(out.sineTo(x, z)) * medium.received(in.sineTo(x, z));
    if (Math.abs(aim) < FAINTEST) {
      return;
    }
    double there = out.distanceTo(x, z);
    double back = in.distanceTo(x, z);
    double slant = 0.5 * (cosine(outline, e, out) + cosine(outline, e, in));
    Complex height = vertical.at(2 * there * back / (there + back));
    double size = medium.perM() / (2 * Math.PI) * slant * aim * outline.lengthM[e] / (there * back);
    size *= medium.leftAfter(there + back);
    double phase = -medium.perM() * (there + back) - medium.delayPhaseRad();
    double re = size * StrictMath.cos(phase);
    double im = size * StrictMath.sin(phase);
    // Times i.
    trace.add(
        medium.cyclesAfter(there + back),
        -(re * height.im() + im * height.re()),
        re * height.re() - im * height.im());
  }
}
