package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Values: Abramowitz and Stegun (1964), tables 26.1 (P) and 26.2 (-log10 Q). */
class NormalDistributionTest {
  @ParameterizedTest
  @CsvSource({
    "0, 0.5",
    "0.5, 0.691462461274013",
    "1, 0.841344746068543",
    "1.96, 0.975002104851780",
    "2, 0.977249868051821",
    "2.5, 0.993790334674224",
    "3, 0.998650101968370",
    "4, 0.999968328758167",
    "9, 1"
  })
  void centre_agreesWithTable261(double x, double published) {
    assertEquals(published, NormalDistribution.cumulative(x), 1e-15 + 5e-16);
  }

  @ParameterizedTest
  @CsvSource({"5, 6.54265", "10, 23.11805", "15, 50.43522", "20, 88.56010", "30, 197.30921"})
  void tail_agreesWithTable262(double x, double minusLog10) {
    assertEquals(minusLog10, -Math.log10(NormalDistribution.cumulative(-x)), 5.1e-6);
  }

  /** Kolmogorov's distance of so many numbers is over 1.95 / 1,000 in one set of 1,000. */
  @Test
  void numbers_areOfTheDistribution() {
    int many = 1_000_000;
    SplittableRandom random = new SplittableRandom(4);
    double[] drawn =
        DoubleStream.generate(() -> NormalDistribution.draw(random)).limit(many).sorted().toArray();
    double most = 0;
    for (int i = 0; i < many; i++) {
      double cumulative = NormalDistribution.cumulative(drawn[i]);
      most =
          Math.max(most, Math.max(cumulative - (double) i / many, (i + 1.0) / many - cumulative));
    }
    assertTrue(most < 1.95 / Math.sqrt(many), "Kolmogorov's distance " + most);
    // Beyond four deviations 63 are expected, so 30 to 96 with four deviations of that number.
    long far = DoubleStream.of(drawn).filter(x -> Math.abs(x) > 4).count();
    assertTrue(far > 30 && far < 96, far + " beyond four deviations");
  }

  /** Bits of the first numbers of a seed: the same on every Java. */
  @Test
  void numbers_ofASeed_areTheseBits() {
    SplittableRandom random = new SplittableRandom(4);
    assertEquals(
        "0x1.2f212e0521a05p0 -0x1.9a4aa6a89e17dp-4 0x1.f744f93fea95dp-3 -0x1.1bd45eadcecc1p0",
        IntStream.range(0, 4)
            .mapToObj(i -> Double.toHexString(NormalDistribution.draw(random)))
            .collect(Collectors.joining(" ")));
  }

  @Test
  void distribution_isSymmetricAndRises() {
    double before = 0;
    for (double x = -12; x <= 12; x += 0.01) {
      double here = NormalDistribution.cumulative(x);
      assertEquals(1, here + NormalDistribution.cumulative(-x), 1e-15, "at " + x);
      assertTrue(here >= before - 1e-16, "falls at " + x);
      before = here;
    }
  }

  /** The two formulas meet at 5 sigma: the density there is 1.5e-6. */
  @Test
  void formulas_meet() {
    double below = NormalDistribution.cumulative(-5 - 1e-9);
    double above = NormalDistribution.cumulative(-5 + 1e-9);
    assertEquals(2e-9 * 1.4867195e-6, above - below, 1e-15);
  }

  @Test
  void infinities_areTheEnds() {
    assertEquals(0, NormalDistribution.cumulative(Double.NEGATIVE_INFINITY));
    assertEquals(1, NormalDistribution.cumulative(Double.POSITIVE_INFINITY));
    assertEquals(0, NormalDistribution.cumulative(-Double.MAX_VALUE));
  }

  @Test
  void notANumber_staysOne() {
    assertTimeoutPreemptively(
        Duration.ofSeconds(20),
        () -> assertTrue(Double.isNaN(NormalDistribution.cumulative(Double.NaN))));
  }
}
