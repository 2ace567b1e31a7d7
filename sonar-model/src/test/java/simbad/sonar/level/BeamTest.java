package simbad.sonar.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.sonar.fixture.Refusal;

class BeamTest {
  private static final double K = Air.ROOM.wavenumberPerM(40_000);

  /**
   * J1(x) of Abramowitz and Stegun 1964, table 9.1, at x = k a sin(angle): 40 log10(2 J1(x) / x).
   */
  @ParameterizedTest
  @CsvSource({
    "0.5, 0.2422684577",
    "1, 0.4400505857",
    "2, 0.5767248078",
    "3, 0.3390589585",
    "4, -0.0660433280",
    "5, -0.3275791376",
    "6, -0.2766838581",
    "8, 0.2346363469",
    "10, 0.0434727462",
    "12, -0.2234471045",
    "15, 0.2051040386"
  })
  void piston_isTheTablesBesselFunction(double x, double besselJ1) {
    PistonBeam beam = PistonBeam.of(17.5 / K, K);
    double expectedDb = 40 * Math.log10(Math.abs(2 * besselJ1 / x));
    assertEquals(expectedDb, beam.twoWayDb(Math.asin(x / 17.5)), 0.01);
  }

  /** Radii in mm, and one way: half the decibels. Computed by another program, rounded to 0.1. */
  @ParameterizedTest
  @CsvSource({
    "6, 10, -0.6",
    "6, 20, -2.6",
    "6, 30, -5.9",
    "6, 40, -10.9",
    "7.25, 10, -0.9",
    "7.25, 20, -3.9",
    "7.25, 30, -9.3",
    "7.25, 40, -19.8"
  })
  void piston_ofARangersSize(double radiusMm, double offAxisDeg, double oneWayDb) {
    double db = PistonBeam.of(radiusMm / 1000, K).twoWayDb(Math.toRadians(offAxisDeg));
    assertEquals(oneWayDb, db / 2, 0.06);
  }

  /** The first zero of J1 is at 3.8317, and the next maximum 17.57 dB below the axis one way. */
  @Test
  void piston_hasANullAndASideLobe() {
    PistonBeam beam = PistonBeam.of(10 / K, K);
    assertTrue(beam.twoWayDb(Math.asin(0.383171)) < -120);
    assertEquals(2 * -17.57, beam.twoWayDb(Math.asin(0.5136)), 0.02);
  }

  @Test
  void piston_hearsAlikeToBothSidesAndNothingBehind() {
    PistonBeam beam = PistonBeam.of(0.007, K);
    assertEquals(0, beam.axisDb());
    assertEquals(1, beam.greatestEnergy());
    assertEquals(1, beam.twoWayEnergy(3, 0));
    assertEquals(1, beam.twoWayEnergy(0, 0));
    assertEquals(beam.twoWayEnergy(2, 1), beam.twoWayEnergy(4, -2));
    assertEquals(0, beam.twoWayEnergy(-1e-9, 1));
    assertEquals(Double.NEGATIVE_INFINITY, beam.twoWayDb(Math.PI));
  }

  @ParameterizedTest
  @CsvSource({"5", "15", "27.5", "45", "89"})
  void halfAmplitude_isMetAtItsAngle(double halfAngleDeg) {
    PistonBeam beam = PistonBeam.ofHalfAmplitude(Math.toRadians(halfAngleDeg), K);
    assertEquals(40 * Math.log10(0.5), beam.twoWayDb(Math.toRadians(halfAngleDeg)), 1e-3);
  }

  /** Devantech's 55 degrees at -6 dB are those of a piston of 13.1 mm. */
  @Test
  void halfAmplitude_ofTheSrf04() {
    PistonBeam beam = PistonBeam.ofHalfAmplitude(Math.toRadians(27.5), K);
    assertEquals(0.00655, beam.apertureRadiusM(), 2e-5);
  }

  @Test
  void piston_ofTheSameFiguresIsComputedOnce() {
    PistonBeam beam = PistonBeam.of(0.0071, K);
    assertSame(beam, PistonBeam.of(0.0071, K));
    PistonBeam other = PistonBeam.of(0.0072, K);
    assertNotEquals(beam, other);
    assertEquals(beam, PistonBeam.of(0.0071, K));
    assertEquals(beam.hashCode(), PistonBeam.of(0.0071, K).hashCode());
    assertTrue(beam.toString().contains("0.0071 m"));
  }

  @Test
  void curve_isReadByDegreesToEitherSide() {
    CurveBeam beam = new CurveBeam(Curve.of(0, -1, 10, -3, 90, -43));
    assertEquals(-1, beam.axisDb());
    assertEquals(-1, beam.twoWayDb(0), 1e-12);
    assertEquals(-2, beam.twoWayDb(Math.toRadians(-5)), 1e-12);
    assertEquals(-8, beam.twoWayDb(Math.toRadians(20)), 1e-12);
    assertEquals(-43, beam.twoWayDb(Math.PI), 1e-12);
    assertEquals(Math.pow(10, -0.1), beam.greatestEnergy(), 1e-12);
    assertEquals(Math.pow(10, -0.8), beam.twoWayEnergy(Math.cos(0.349066), 0.342020), 1e-6);
  }

  @Test
  void everywhere_isOne() {
    assertEquals(1, Beam.everywhere().twoWayEnergy(-1, 0.3));
  }

  @Test
  void impossiblePiston_isRefused() {
    Refusal.check(() -> PistonBeam.of(0, K), "apertureRadiusM = 0.0 is not in (0, infinity)");
    Refusal.check(() -> PistonBeam.of(0.01, Double.NaN), "wavenumberPerM = NaN");
    Refusal.check(() -> PistonBeam.ofHalfAmplitude(2, K), "halfAngleRad = 2.0");
  }
}
