package simbad.sonar.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.random.RandomGenerator;
import net.jqwik.api.ForAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.fixture.Refusal;
import simbad.sonar.fixture.Seeded;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;

class ReadingDistributionTest {
  private static final double NO_ECHO_M = 6;

  private static Sight sight(double nearestM, double probability) {
    return new Sight(1, 0, 1, OptionalDouble.of(nearestM), probability);
  }

  private static ReadingDistribution of(double noiseM, double resolutionM, Sight... heard) {
    return ReadingDistribution.nearestFirst(List.of(heard), noiseM, resolutionM);
  }

  /** Up to four obstacles; noise and resolution may be 0. */
  private static ReadingDistribution any(RandomGenerator random) {
    List<Sight> heard = new ArrayList<>();
    for (int i = random.nextInt(5); i > 0; i--) {
      heard.add(sight(random.nextDouble(0, 4), random.nextDouble()));
    }
    heard.sort(Comparator.comparingDouble(sight -> sight.nearestM().orElseThrow()));
    double noise = random.nextInt(3) == 0 ? 0 : random.nextDouble(0.001, 0.2);
    double resolution = random.nextInt(3) == 0 ? 0 : random.nextDouble(0.005, 0.3);
    return ReadingDistribution.nearestFirst(heard, noise, resolution);
  }

  @Seeded
  void probabilities_sumToOne(@ForAll Random random) {
    ReadingDistribution distribution = any(random);
    assertEquals(1, distribution.echoUpTo(1e3) + distribution.noEchoProbability(), 1e-12);
    assertEquals(
        1,
        distribution.echoUpTo(Double.POSITIVE_INFINITY) + distribution.noEchoProbability(),
        1e-12);
  }

  @Seeded
  void echoUpTo_neverFalls(@ForAll Random random) {
    ReadingDistribution distribution = any(random);
    double before = 0;
    for (double range = -0.5; range < 6; range += 0.013) {
      double here = distribution.echoUpTo(range);
      assertTrue(here >= before - 1e-15 && here <= 1 + 1e-15, "at " + range + ": " + here);
      before = here;
    }
  }

  /** Up to a quantile lies at least its level, below it no more: no-echo counts as 6 m or 1 m. */
  @Seeded
  void quantiles_areOrderedAndInverse(@ForAll Random random) {
    ReadingDistribution distribution = any(random);
    double noEchoM = random.nextBoolean() ? NO_ECHO_M : 1;
    double before = 0;
    for (int percent = 5; percent <= 95; percent += 5) {
      double level = percent / 100.0;
      double quantile = distribution.quantileM(level, noEchoM);
      assertTrue(quantile >= before, "q" + percent + " = " + quantile + " < " + before);
      double upTo = upTo(distribution, quantile + 1e-9, noEchoM);
      double below = upTo(distribution, quantile - 1e-6, noEchoM);
      assertTrue(upTo >= level - 1e-9, "up to q" + percent + " = " + quantile + ": " + upTo);
      assertTrue(below <= level + 1e-9, "below q" + percent + " = " + quantile + ": " + below);
      before = quantile;
    }
  }

  private static double upTo(ReadingDistribution distribution, double rangeM, double noEchoM) {
    return distribution.echoUpTo(rangeM)
        + (rangeM >= noEchoM ? distribution.noEchoProbability() : 0);
  }

  @Seeded
  void steps_shareTheEchoes(@ForAll Random random) {
    double resolution = random.nextDouble(0.02, 0.3);
    double noise = random.nextBoolean() ? 0 : 0.1;
    ReadingDistribution distribution = of(noise, resolution, sight(0.9, 0.4), sight(1.3, 0.7));
    double sum = 0;
    for (int step = 0; step * resolution < 4; step++) {
      double share = distribution.probabilityOfStep(step * resolution);
      assertTrue(share >= 0, "step " + step + ": " + share);
      sum += share;
    }
    assertEquals(1 - 0.6 * 0.3, sum, 1e-12);
  }

  /**
   * Against 4,000 draws each. By Dvoretzky, Kiefer and Wolfowitz with Massart's (1990) constant the
   * empirical distribution is off by 0.05 anywhere with probability below 2 exp(-2 n 0.05^2) = 4e-9
   * each, less than 1e-6 for the 30 distributions; the seeds are fixed.
   */
  @Test
  void samples_followTheDistribution() {
    for (int seed = 0; seed < 30; seed++) {
      Random random = new Random(seed);
      ReadingDistribution distribution = any(random);
      List<Reading> draws = new ArrayList<>();
      for (int i = 0; i < 4000; i++) {
        draws.add(distribution.sample(random));
      }
      for (double range = 0; range < 5; range += 0.1) {
        double limit = range;
        long upTo = draws.stream().filter(r -> r instanceof Echo e && e.rangeM() <= limit).count();
        assertEquals(upTo / 4000.0, distribution.echoUpTo(range), 0.05, seed + " at " + range);
      }
      long none = draws.stream().filter(r -> r == NoEcho.NO_ECHO).count();
      assertEquals(none / 4000.0, distribution.noEchoProbability(), 0.05);
    }
  }

  @Test
  void nearest_isReadFirst() {
    ReadingDistribution distribution = of(0, 0, sight(1, 0.5), sight(2, 0.8));
    assertEquals(0.5, distribution.echoUpTo(1), 1e-15);
    assertEquals(0.5 + 0.5 * 0.8, distribution.echoUpTo(2), 1e-15);
    assertEquals(0.5 * 0.2, distribution.noEchoProbability(), 1e-15);
  }

  /** Median d, one sigma above it at the level P(1) = 0.8413. */
  @Test
  void quantiles_ofOneCertainEcho_areThoseOfTheNormal() {
    ReadingDistribution distribution = of(0.01, 0, sight(1.5, 1));
    assertEquals(1.5, distribution.quantileM(0.5, NO_ECHO_M), 1e-9);
    assertEquals(1.51, distribution.quantileM(0.841344746068543, NO_ECHO_M), 1e-9);
    assertEquals(1.48, distribution.quantileM(1 - 0.977249868051821, NO_ECHO_M), 1e-9);
  }

  /** Half the pings answer at 1 m: the other half stand where a no-echo counts. */
  @ParameterizedTest
  @CsvSource({"6, 0.49, 1", "6, 0.51, 6", "0.5, 0.49, 0.5", "0.5, 0.51, 1", "0, 0.49, 0"})
  void quantiles_countNoEchoAsARange(double noEchoM, double level, double expected) {
    assertEquals(expected, of(0, 0, sight(1, 0.5)).quantileM(level, noEchoM), 1e-12);
  }

  @Test
  void quantiles_ofSilence_areTheNoEchoRange() {
    ReadingDistribution silence = of(0.01, 0.01);
    assertEquals(1, silence.noEchoProbability());
    assertEquals(NO_ECHO_M, silence.quantileM(0.05, NO_ECHO_M));
    assertEquals(NO_ECHO_M, silence.quantileM(0.95, NO_ECHO_M));
    assertEquals(NoEcho.NO_ECHO, silence.sample(new Random(1)));
  }

  /** What is read is rounded down: 1.2345 m reads 1.23 m, all within 1.23 to 1.24 counts as it. */
  @Test
  void readings_areRoundedDown() {
    ReadingDistribution distribution = of(0, 0.01, sight(1.2345, 1));
    assertEquals(0, distribution.echoUpTo(1.2299));
    assertEquals(1, distribution.echoUpTo(1.23));
    assertEquals(1, distribution.probabilityOfStep(1.2375));
    assertEquals(0, distribution.probabilityOfStep(1.24));
    assertEquals(1.23, distribution.quantileM(0.5, NO_ECHO_M), 1e-12);
    assertEquals(new Echo(123 * 0.01), distribution.sample(new Random(1)));
  }

  /** A distance on a step's border reads that step, in draws as in probabilities. */
  @Test
  void distanceOnAStep_readsThatStep() {
    for (int step = 1; step < 600; step++) {
      double distance = step / 100.0;
      ReadingDistribution distribution = of(0, 0.01, sight(distance, 1));
      String at = "at " + distance;
      assertEquals(1, distribution.probabilityOfStep(distance), at);
      assertEquals(0, distribution.echoUpTo(distance - 0.005), at);
      assertEquals(distance, distribution.quantileM(0.5, NO_ECHO_M), 1e-12, at);
      assertEquals(distance, ((Echo) distribution.sample(new Random(1))).rangeM(), 1e-12, at);
    }
  }

  /** Half of what noise of 0.1 m makes of 0 m would lie below 0. */
  @Test
  void readings_areNeverBelow0() {
    for (double resolution : new double[] {0, 0.01}) {
      ReadingDistribution distribution = of(0.1, resolution, sight(0, 1));
      assertEquals(0, distribution.echoUpTo(-1e-9));
      assertEquals(0, distribution.quantileM(0.4, NO_ECHO_M), 1e-12);
      assertTrue(distribution.echoUpTo(0) >= 0.5);
      Random random = new Random(3);
      for (int i = 0; i < 100; i++) {
        assertTrue(((Echo) distribution.sample(random)).rangeM() >= 0);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1, -0.1, 1.1, Double.NaN})
  void level_outOfItsDomain_isRefused(double bad) {
    Refusal.check(() -> of(0, 0).quantileM(bad, 6), "level = " + bad, "(0, 1)");
  }

  @Test
  void rangeThatIsNoNumber_isRefused() {
    ReadingDistribution distribution = of(0.01, 0.01, sight(1, 0.9));
    assertTimeoutPreemptively(
        Duration.ofSeconds(20),
        () -> {
          Refusal.check(() -> distribution.echoUpTo(Double.NaN), "rangeM = NaN");
          Refusal.check(() -> distribution.probabilityOfStep(Double.NaN), "rangeM = NaN");
          Refusal.check(() -> distribution.quantileM(0.5, Double.NaN), "noEchoM = NaN");
        });
  }

  @Test
  void probabilityOfStep_withoutResolution_isRefused() {
    IllegalStateException refused =
        assertThrows(IllegalStateException.class, () -> of(0.01, 0).probabilityOfStep(1));
    assertTrue(String.valueOf(refused.getMessage()).contains("resolutionM = 0"));
  }

  /** A half that hears at 1 m, a quarter at 2 m, and a quarter that hears nothing. */
  @Test
  void mixture_isTheMeanOfItsParts() {
    ReadingDistribution near = of(0.01, 0, sight(1, 0.9));
    ReadingDistribution far = of(0.01, 0, sight(2, 0.8));
    ReadingDistribution silent = of(0.01, 0);
    ReadingDistribution mixed = near.mixed(List.of(far, silent), 0.25, 0.25);
    for (double rangeM : new double[] {0.5, 0.99, 1, 1.5, 2.01, 3}) {
      assertEquals(
          0.5 * near.echoUpTo(rangeM) + 0.25 * far.echoUpTo(rangeM), mixed.echoUpTo(rangeM), 1e-12);
    }
    assertEquals(1 - 0.5 * 0.9 - 0.25 * 0.8, mixed.noEchoProbability(), 1e-12);
    assertEquals(near.noEchoProbability(), near.mixed(List.of()).noEchoProbability());
    assertThrows(IllegalArgumentException.class, () -> near.mixed(List.of(far, silent), 0.75, 0.5));
    assertThrows(IllegalArgumentException.class, () -> near.mixed(List.of(far), Double.NaN));
  }

  /** Three in a hundred read 0, nine in ten 1 m or some steps beside it, the rest nothing. */
  @Test
  void expectation_countsSingleRanges_eachByItself() {
    List<Part> parts = List.of(new Part(0, 0, 0, 0.03), new Part(1, 0.02, 0, 0.9));
    ReadingDistribution given = new ReadingDistribution(parts, 0.01, Report.AS_MEASURED);
    assertEquals(0.03, given.expected(range -> range < 0.5 ? 1 : 0, 4, 12), 1e-12);
    assertEquals(0.9, given.expected(range -> range > 0.5 && range < 3 ? 1 : 0, 4, 12), 1e-12);
    assertEquals(0.07, given.expected(range -> range == 4 ? 1 : 0, 4, 12), 1e-12);
    // Rounded down, a range is half a step less on average.
    assertEquals(0.9 * 0.995 + 0.07 * 4, given.expected(range -> range, 4, 12), 1e-3);
    assertEquals(
        4, new ReadingDistribution(List.of(), 0, Report.AS_MEASURED).expected(r -> r, 4, 1));
  }
}
