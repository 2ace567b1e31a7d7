package simbad.gap.calibrate.level;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.hipparchus.special.Erf;
import org.junit.jupiter.api.Test;

/** Curves beside the probit law that they follow. */
class EchoCurvesTest {
  private static double read(double decibels) {
    return Math.log(0.002 + 0.996 * Erf.erfc(-decibels / Math.sqrt(2)) / 2);
  }

  /**
   * A reading that was heard at 1 dB, and one that no level moves. Not static: the threads that ask
   * the law would wait for this class, and this class for them.
   */
  private final EchoCurves curves =
      new EchoCurves(decibels -> new double[] {read(1 + decibels), -0.5});

  private double[] at(double decibels) {
    double[] into = new double[3];
    curves.at(0, decibels, into);
    return into;
  }

  @Test
  void betweenKnotsTheCurveIsNearTheLaw() {
    for (double shift = -5; shift <= 5; shift += 0.1) {
      assertEquals(read(1 + shift), at(shift)[0], 0.12, "at " + shift);
    }
  }

  @Test
  void derivativesAreThoseOfTheCurve() {
    double step = 1e-4;
    for (double shift : new double[] {-4.1, -2.7, -0.3, 0.4, 2.9}) {
      double slope = (at(shift + step)[0] - at(shift - step)[0]) / (2 * step);
      double bend = (at(shift + step)[1] - at(shift - step)[1]) / (2 * step);
      assertEquals(slope, at(shift)[1], 1e-6, "slope at " + shift);
      assertEquals(bend, at(shift)[2], 1e-4, "bend at " + shift);
    }
  }

  /** Between two knots nothing is likelier than at both. */
  @Test
  void aMonotoneLawGivesAMonotoneCurve() {
    double[] values =
        java.util.stream.DoubleStream.iterate(-14, x -> x <= 14, x -> x + 0.05)
            .map(x -> at(x)[0])
            .toArray();
    double[] sorted = values.clone();
    Arrays.sort(sorted);

    assertEquals(0, Arrays.mismatch(values, sorted) + 1, "first step down");
  }

  @Test
  void beyondTheKnotsTheCurveIsFlat() {
    assertEquals(at(14)[0], at(40)[0]);
    assertEquals(0, at(40)[1]);
  }

  @Test
  void whatNoLevelMovesIsFlat() {
    assertTrue(curves.isFlat(1));
    assertFalse(curves.isFlat(0));
  }

  /** A parabola is met exactly where it does not turn: -(x - 9)² / 2 and its derivatives. */
  @Test
  void aParabolaIsMetExactly() {
    EchoCurves parabola = new EchoCurves(x -> new double[] {-(x - 9) * (x - 9) / 2});
    double[] into = new double[3];
    for (double at : new double[] {-8, -5.2, -1, 0, 0.4, 2, 3.9, 5}) {
      parabola.at(0, at, into);
      assertEquals(-(at - 9) * (at - 9) / 2, into[0], 1e-9, "at " + at);
      assertEquals(9 - at, into[1], 1e-9, "slope at " + at);
      assertEquals(-1, into[2], 1e-9, "bend at " + at);
    }
  }

  /** On either side of the knots the reading is as likely as at the last of them. */
  @Test
  void beyondEitherEndNothingChanges() {
    assertEquals(read(-13), at(-30)[0], 1e-12);
    assertEquals(read(15), at(30)[0], 1e-12);
    assertEquals(0, at(-30)[1]);
    assertEquals(0, at(-30)[2]);
    assertEquals(0, at(30)[2]);
  }

  @Test
  void eachReadingHasItsCurve() {
    assertEquals(2, curves.size());
  }
}
