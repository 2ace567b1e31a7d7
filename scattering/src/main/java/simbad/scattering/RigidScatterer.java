package simbad.scattering;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.ejml.data.ZMatrixRMaj;
import org.ejml.dense.row.decompose.lu.LUDecompositionAlt_ZDRM;
import simbad.sonar.check.Checks;
import simbad.sonar.shape.Outline;

/**
 * How a rigid, infinitely long upright body scatters plane waves of one frequency: the exterior
 * Neumann problem of the Helmholtz equation in two dimensions, time factor e^(-i w t).
 *
 * <p>Direct boundary elements: total pressure p constant on each element, collocated at one point
 * of each. The equation is Burton and Miller's (1971), p/2 - M p - (i/k) N p = p_inc + (i/k)
 * dp_inc/dn with the double layer M and its normal derivative N, because the first half alone has
 * no unique solution at the resonances of the body's inside. N is never integrated: with p constant
 * on an element Maue's identity leaves the tangential derivative of Green's function at the
 * element's two ends and a weakly singular rest (Colton and Kress 2013, section 3.1).
 *
 * <p>Thread-safe.
 */
public final class RigidScatterer {
  /** How uniqueness is ensured. */
  enum Formulation {
    /** Burton and Miller's; unique at every frequency. */
    BURTON_MILLER,
    /** The first half alone, wrong at resonances of the inside; only to show that. */
    PLAIN
  }

  private final Boundary boundary;
  private final double wavenumber;
  private final double coupling;
  private final LUDecompositionAlt_ZDRM factors = new LUDecompositionAlt_ZDRM();

  private RigidScatterer(Boundary boundary, double wavenumber, Formulation formulation) {
    this.boundary = boundary;
    this.wavenumber = wavenumber;
    coupling = formulation == Formulation.PLAIN ? 0 : 1 / wavenumber;
  }

  /**
   * Prepares a body.
   *
   * @param outlines of its cross-section's bodies, which cross neither themselves nor each other;
   *     either sense of going round
   * @param wavenumberPerM k = 2 pi f / c, radians per metre, positive
   * @param elementM greatest length of an element, metres, positive; a tenth of the wavelength or
   *     less
   */
  public static RigidScatterer of(List<Outline> outlines, double wavenumberPerM, double elementM) {
    Checks.positive("wavenumberPerM", wavenumberPerM);
    Checks.positive("elementM", elementM);
    return of(outlines, wavenumberPerM, elementM, Formulation.BURTON_MILLER);
  }

  static RigidScatterer of(
      List<Outline> outlines, double wavenumberPerM, double elementM, Formulation formulation) {
    RigidScatterer scatterer =
        new RigidScatterer(Boundary.of(outlines, elementM), wavenumberPerM, formulation);
    if (!scatterer.factors.decompose(scatterer.matrix()) || scatterer.factors.isSingular()) {
      throw new IllegalArgumentException(
          "outlines give equations that cannot be solved: " + outlines);
    }
    return scatterer;
  }

  /** Returns the number of elements. */
  public int elements() {
    return boundary.size();
  }

  private ZMatrixRMaj matrix() {
    int n = boundary.size();
    ZMatrixRMaj matrix = new ZMatrixRMaj(n, n);
    LayerPotentials layers = new LayerPotentials(boundary, wavenumber);
    IntStream.range(0, n).parallel().forEach(i -> layers.fillRow(i, coupling, matrix.data));
    return matrix;
  }

  /**
   * Returns the amplitude f of the echo: far away, at distance r back where the wave came from, the
   * scattered pressure is f e^(ikr) / sqrt(r) for an incident wave of amplitude 1.
   *
   * @param bearingsRad of the sensor in the body's frame
   * @return |f| per bearing, square roots of metres
   */
  public double[] backscatter(double[] bearingsRad) {
    return Arrays.stream(bearingsRad).parallel().map(this::backscatter).toArray();
  }

  private double backscatter(double bearingRad) {
    double towardsX = Math.sin(bearingRad);
    double towardsZ = Math.cos(bearingRad);
    double[] pressure = incident(towardsX, towardsZ);
    // What the factors keep is only read by it: several bearings may be solved for at once.
    factors._solveVectorInternal(pressure);
    return farField(pressure, towardsX, towardsZ);
  }

  /** Right side of the equations, real and imaginary parts by turns. */
  private double[] incident(double towardsX, double towardsZ) {
    double[] incident = new double[2 * boundary.size()];
    for (int i = 0; i < boundary.size(); i++) {
      double phase =
          -wavenumber * (towardsX * boundary.collocationX(i) + towardsZ * boundary.collocationZ(i));
      // (i/k) dp/dn = (i/k) (-i k towards.n) p
      double factor = 1 + coupling * wavenumber * facing(i, towardsX, towardsZ);
      incident[2 * i] = factor * Math.cos(phase);
      incident[2 * i + 1] = factor * Math.sin(phase);
    }
    return incident;
  }

  /** Cosine of the angle between a direction and an element's normal. */
  private double facing(int j, double towardsX, double towardsZ) {
    return towardsX * boundary.tangentZ(j) - towardsZ * boundary.tangentX(j);
  }

  /** Each element's share is exact: a straight line of constant pressure. */
  private double farField(double[] pressure, double towardsX, double towardsZ) {
    double re = 0;
    double im = 0;
    for (int j = 0; j < boundary.size(); j++) {
      double along =
          wavenumber
              * boundary.lengthM(j)
              / 2
              * (towardsX * boundary.tangentX(j) + towardsZ * boundary.tangentZ(j));
      double spread = Math.abs(along) < 1e-8 ? 1 : Math.sin(along) / along;
      double weight = boundary.lengthM(j) * spread * facing(j, towardsX, towardsZ);
      double phase =
          -wavenumber * (towardsX * boundary.middleX(j) + towardsZ * boundary.middleZ(j));
      double cos = Math.cos(phase);
      double sin = Math.sin(phase);
      re += weight * (pressure[2 * j] * cos - pressure[2 * j + 1] * sin);
      im += weight * (pressure[2 * j] * sin + pressure[2 * j + 1] * cos);
    }
    return wavenumber / Math.sqrt(8 * Math.PI * wavenumber) * Math.hypot(re, im);
  }
}
