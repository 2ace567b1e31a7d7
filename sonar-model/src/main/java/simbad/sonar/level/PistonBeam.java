package simbad.sonar.level;

import java.util.Arrays;
import simbad.sonar.check.Checks;

/**
 * The beam of a round piston in an endless baffle that sends and of an equal one that receives.
 *
 * <p>Either way the amplitude is D = 2 J1(x) / x with x = k a sin(angle), 1 at the axis (Morse and
 * Ingard 1968, section 7.4), so that the echo's energy falls by D^4. Behind the baffle nothing is
 * heard. D is a smooth function of sin^2(angle) and kept as a table of it: within 1e-6 of the
 * formula for every transducer in air, which is 0.001 dB down to 40 dB below the axis, both ways.
 * Immutable.
 */
public final class PistonBeam implements Beam {
  /** Cells of the table for each unit of (k a)^2. */
  private static final int CELLS_PER_UNIT = 64;

  private static final int LEAST_CELLS = 256;
  private static final int MOST_CELLS = 16_384;

  /** A belt is bound to its scene again whenever something moves; its beam stays. */
  private static volatile PistonBeam latest = create(0.00655, 732);

  private final double apertureRadiusM;
  private final double wavenumberPerM;
  private final int cells;

  /** D at sin^2 = i / cells. */
  private final double[] amplitude;

  private PistonBeam(double apertureRadiusM, double wavenumberPerM, double[] amplitude) {
    this.apertureRadiusM = apertureRadiusM;
    this.wavenumberPerM = wavenumberPerM;
    this.amplitude = amplitude;
    cells = amplitude.length - 1;
  }

  /**
   * Creates a beam.
   *
   * @param apertureRadiusM radius of the piston, metres; positive, finite
   * @param wavenumberPerM k = 2 pi f / c, radians per metre; positive, finite
   */
  public static PistonBeam of(double apertureRadiusM, double wavenumberPerM) {
    Checks.positive("apertureRadiusM", apertureRadiusM);
    Checks.positive("wavenumberPerM", wavenumberPerM);
    PistonBeam beam = latest;
    if (beam.apertureRadiusM != apertureRadiusM || beam.wavenumberPerM != wavenumberPerM) {
      beam = create(apertureRadiusM, wavenumberPerM);
      latest = beam;
    }
    return beam;
  }

  private static PistonBeam create(double apertureRadiusM, double wavenumberPerM) {
    double ka = wavenumberPerM * apertureRadiusM;
    int cells = (int) Math.max(LEAST_CELLS, Math.min(MOST_CELLS, CELLS_PER_UNIT * ka * ka));
    double[] amplitude = new double[cells + 1];
    Arrays.setAll(amplitude, i -> directivity(ka * Math.sqrt((double) i / cells)));
    return new PistonBeam(apertureRadiusM, wavenumberPerM, amplitude);
  }

  /**
   * Creates the beam whose amplitude one way is half of that at the axis (6 dB less) at an angle.
   *
   * @param halfAngleRad in (0, pi/2)
   * @param wavenumberPerM k = 2 pi f / c, radians per metre; positive, finite
   */
  public static PistonBeam ofHalfAmplitude(double halfAngleRad, double wavenumberPerM) {
    if (!(halfAngleRad > 0 && halfAngleRad < Math.PI / 2)) {
      throw new IllegalArgumentException("halfAngleRad = " + halfAngleRad + " is not in (0, pi/2)");
    }
    double low = 0;
    double high = 3;
    while (Math.nextUp(low) < high) {
      double middle = (low + high) / 2;
      if (directivity(middle) > 0.5) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return of(high / (wavenumberPerM * Math.sin(halfAngleRad)), wavenumberPerM);
  }

  /**
   * 2 J1(x) / x by Bessel's integral, 4 / pi times that of sin(t) sin(x sin t) / x over a quarter
   * turn. The trapezoidal rule of a periodic function is exact to the last digits once it has
   * somewhat more points than x.
   */
  private static double directivity(double x) {
    if (x == 0) {
      return 1;
    }
    int quarter = 16 + (int) (x / 2);
    double sum = 0;
    for (int i = 1; i <= quarter; i++) {
      double sin = Math.sin(i * Math.PI / (2 * quarter));
      double part = x * sin > 1e-8 ? Math.sin(x * sin) / x : sin;
      sum += (i == quarter ? 0.5 : 1) * sin * part;
    }
    return 2 * sum / quarter;
  }

  /** Returns the radius of the piston in metres. */
  public double apertureRadiusM() {
    return apertureRadiusM;
  }

  /** Returns k in radians per metre. */
  public double wavenumberPerM() {
    return wavenumberPerM;
  }

  @Override
  public double twoWayEnergy(double along, double across) {
    if (along < 0) {
      return 0;
    }
    double across2 = across * across;
    double length2 = along * along + across2;
    double at = length2 > 0 ? cells * (across2 / length2) : 0;
    int cell = Math.min((int) at, cells - 1);
    double here = amplitude[cell];
    double oneWay = here + (amplitude[cell + 1] - here) * (at - cell);
    double energy = oneWay * oneWay;
    return energy * energy;
  }

  @Override
  public double greatestEnergy() {
    return 1;
  }

  @Override
  public double axisDb() {
    return 0;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof PistonBeam that
        && apertureRadiusM == that.apertureRadiusM
        && wavenumberPerM == that.wavenumberPerM;
  }

  @Override
  public int hashCode() {
    return 31 * Double.hashCode(apertureRadiusM) + Double.hashCode(wavenumberPerM);
  }

  @Override
  public String toString() {
    return "PistonBeam[" + apertureRadiusM + " m, " + wavenumberPerM + " rad/m]";
  }
}
