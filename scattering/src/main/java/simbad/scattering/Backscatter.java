package simbad.scattering;

import java.util.Arrays;
import java.util.List;
import simbad.sonar.frame.Angles;
import simbad.sonar.level.Air;
import simbad.sonar.shape.Outline;

/**
 * How strongly a cross-section echoes, by bearing, as a bench would see it.
 *
 * <p>The echo's power is averaged over neighbouring bearings with a normal weight of standard
 * deviation {@value #SMEARING_DEG} degrees: for the width that transducer and burst have, and for
 * bearings that a bench sets by hand. Immutable.
 */
public final class Backscatter {
  /** The transducers' nominal frequency. */
  public static final double FREQUENCY_HZ = 40_000;

  /** Standard deviation of the bearing over which an echo's power is averaged. */
  public static final double SMEARING_DEG = 4;

  /** Greatest element on outlines of up to 20 cm all round: 34 in a wavelength. */
  private static final double FINE_ELEMENT_M = 0.25e-3;

  /** Larger outlines get this many elements, as long as they are short enough. */
  private static final int ELEMENTS = 800;

  private static final double SHARE_OF_WAVELENGTH = 0.1;

  /** The power's harmonics go up to 4 k R; this many samples for each of them. */
  private static final double SAMPLES_PER_HARMONIC = 2.2;

  private static final double NEGLIGIBLE_SIGMAS = 4;

  private final double[] amplitude;

  private Backscatter(double[] amplitude) {
    this.amplitude = amplitude;
  }

  /**
   * Computes a cross-section's echoes.
   *
   * @param outlines of its bodies, metres, the centre of the bearings at the origin
   * @param air for the speed of sound
   * @param bearings number of bearings, evenly spaced from 0
   */
  public static Backscatter of(List<Outline> outlines, Air air, int bearings) {
    return of(outlines, air, bearings, elementM(outlines, air));
  }

  /** The same with elements of another greatest length, to see whether it makes a difference. */
  static Backscatter of(List<Outline> outlines, Air air, int bearings, double elementM) {
    double wavenumber = air.wavenumberPerM(FREQUENCY_HZ);
    int fine = samplesPerBearing(outlines, wavenumber, bearings);
    double[] at = new double[bearings * fine];
    Arrays.setAll(at, i -> i * Angles.TURN_RAD / at.length);
    double[] raw = RigidScatterer.of(outlines, wavenumber, elementM).backscatter(at);
    return new Backscatter(smeared(raw, fine, Math.toRadians(SMEARING_DEG)));
  }

  /** Returns the greatest element that {@link #of(List, Air, int)} uses, metres. */
  static double elementM(List<Outline> outlines, Air air) {
    double wavelengthM = Angles.TURN_RAD / air.wavenumberPerM(FREQUENCY_HZ);
    double perimeterM = outlines.stream().mapToDouble(Outline::perimeterM).sum();
    double affordable = Math.max(FINE_ELEMENT_M, perimeterM / ELEMENTS);
    return Math.min(SHARE_OF_WAVELENGTH * wavelengthM, affordable);
  }

  private static int samplesPerBearing(List<Outline> outlines, double wavenumber, int bearings) {
    double reachM = outlines.stream().mapToDouble(outline -> outline.reachM(0, 0)).max().orElse(0);
    double samples = SAMPLES_PER_HARMONIC * 4 * wavenumber * reachM;
    return Math.max(1, (int) Math.ceil(samples / bearings));
  }

  /** Root of the mean power round every fine-th sample. */
  static double[] smeared(double[] raw, int fine, double sigmaRad) {
    double step = Angles.TURN_RAD / raw.length / sigmaRad;
    int width = (int) Math.ceil(NEGLIGIBLE_SIGMAS / step);
    double[] result = new double[raw.length / fine];
    for (int i = 0; i < result.length; i++) {
      double power = 0;
      double weights = 0;
      for (int d = -width; d <= width; d++) {
        double weight = Math.exp(-0.5 * d * d * step * step);
        double value = raw[Math.floorMod(i * fine + d, raw.length)];
        power += weight * value * value;
        weights += weight;
      }
      result[i] = Math.sqrt(power / weights);
    }
    return result;
  }

  /** Returns the number of bearings. */
  public int size() {
    return amplitude.length;
  }

  /**
   * Returns the level of the echo in decibels: 20 log |f| with |f| in square roots of metres.
   *
   * @param index of the bearing, from 0
   */
  public double levelDb(int index) {
    return 20 * Math.log10(amplitude[index]);
  }
}
