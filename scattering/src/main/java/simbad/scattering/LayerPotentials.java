package simbad.scattering;

/**
 * The rows of Burton and Miller's equation, element by element, by Gauss's rule.
 *
 * <p>Green's function is G = (i/4) H0(k r). Thread-safe.
 */
final class LayerPotentials {
  /** Gauss's rule of 4 points on (-1, 1). */
  private static final double[] NODES = {
    -0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526
  };

  private static final double[] WEIGHTS = {
    0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538
  };

  /** The rule of 2 points is enough for elements further away than this many of their lengths. */
  private static final double FAR_LENGTHS = 6;

  private static final double[] FAR_NODES = {-0.5773502691896258, 0.5773502691896258};
  private static final double[] FAR_WEIGHTS = {1, 1};

  private final Boundary boundary;
  private final double k;

  LayerPotentials(Boundary boundary, double wavenumber) {
    this.boundary = boundary;
    this.k = wavenumber;
  }

  /**
   * Writes row i of p/2 - M p - i coupling N p.
   *
   * @param i element at whose point the equation holds
   * @param coupling of N, metres
   * @param data of the matrix, row by row, real and imaginary parts by turns
   */
  void fillRow(int i, double coupling, double[] data) {
    int n = boundary.size();
    double[] ends = coupling == 0 ? new double[2 * n] : endTerms(i);
    int row = 2 * i * n;
    for (int j = 0; j < n; j++) {
      double[] layers = i == j ? ownLayers(i) : layers(i, j);
      double alike =
          boundary.tangentX(i) * boundary.tangentX(j) + boundary.tangentZ(i) * boundary.tangentZ(j);
      double hyperRe = ends[2 * j] + k * k * alike * layers[0];
      double hyperIm = ends[2 * j + 1] + k * k * alike * layers[1];
      data[row + 2 * j] = (i == j ? 0.5 : 0) - layers[2] + coupling * hyperIm;
      data[row + 2 * j + 1] = -layers[3] - coupling * hyperRe;
    }
  }

  /**
   * Derivative of G along element i at its point, for a source at each element's begin less one at
   * its end.
   */
  private double[] endTerms(int i) {
    int n = boundary.size();
    double[] ends = new double[2 * n];
    double[] last = slope(i, boundary.fromX(0), boundary.fromZ(0));
    for (int j = 0; j < n; j++) {
      double[] begin = joined(j) ? last : slope(i, boundary.fromX(j), boundary.fromZ(j));
      last = slope(i, boundary.toX(j), boundary.toZ(j));
      ends[2 * j] = begin[0] - last[0];
      ends[2 * j + 1] = begin[1] - last[1];
    }
    return ends;
  }

  private boolean joined(int j) {
    return j > 0
        && boundary.toX(j - 1) == boundary.fromX(j)
        && boundary.toZ(j - 1) == boundary.fromZ(j);
  }

  private double[] slope(int i, double sourceX, double sourceZ) {
    double dx = boundary.collocationX(i) - sourceX;
    double dz = boundary.collocationZ(i) - sourceZ;
    double r = distanceM(dx, dz);
    double slope = (dx * boundary.tangentX(i) + dz * boundary.tangentZ(i)) / r;
    Hankel h = Hankel.at(k * r);
    // (i/4) (-k H1) slope
    return new double[] {k / 4 * slope * h.y1(), -k / 4 * slope * h.j1()};
  }

  /** Without hypot's care for numbers near the ends of a double's range, which takes its time. */
  private static double distanceM(double dx, double dz) {
    return Math.sqrt(dx * dx + dz * dz);
  }

  /** Real and imaginary part of the integral of G over element j, then of dG/dn. */
  private double[] layers(int i, int j) {
    double tx = boundary.tangentX(j);
    double tz = boundary.tangentZ(j);
    double half = boundary.lengthM(j) / 2;
    double dx = boundary.collocationX(i) - boundary.middleX(j);
    double dz = boundary.collocationZ(i) - boundary.middleZ(j);
    boolean far = distanceM(dx, dz) > FAR_LENGTHS * 2 * half;
    double[] nodes = far ? FAR_NODES : NODES;
    double[] weights = far ? FAR_WEIGHTS : WEIGHTS;
    double height = dx * tz - dz * tx; // over the line of element j, along its normal
    double[] sums = new double[4];
    for (int g = 0; g < nodes.length; g++) {
      double ax = dx - nodes[g] * half * tx;
      double az = dz - nodes[g] * half * tz;
      double r = distanceM(ax, az);
      Hankel h = Hankel.at(k * r);
      double single = weights[g] * half / 4;
      // (i/4) k H1 height / r
      double twin = single * k * height / r;
      sums[0] -= single * h.y0();
      sums[1] += single * h.j0();
      sums[2] -= twin * h.y1();
      sums[3] += twin * h.j1();
    }
    return sums;
  }

  /** Over the element itself, to both sides of its point; straight, so no dG/dn. */
  private double[] ownLayers(int i) {
    double[] sums = new double[4];
    double beginM =
        Math.hypot(
            boundary.collocationX(i) - boundary.fromX(i),
            boundary.collocationZ(i) - boundary.fromZ(i));
    addSide(beginM, sums);
    addSide(boundary.lengthM(i) - beginM, sums);
    return sums;
  }

  /** s = length u^3 takes the logarithm away. */
  private void addSide(double lengthM, double[] sums) {
    for (int g = 0; g < NODES.length; g++) {
      double u = (1 + NODES[g]) / 2;
      Hankel h = Hankel.at(k * lengthM * u * u * u);
      // du is half of the rule's interval.
      double single = WEIGHTS[g] / 2 * 3 * u * u * lengthM / 4;
      sums[0] -= single * h.y0();
      sums[1] += single * h.j0();
    }
  }
}
