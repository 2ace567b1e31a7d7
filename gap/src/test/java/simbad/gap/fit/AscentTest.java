package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Parameter;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.effect.Form;

/** Log likelihoods in closed form, of two values. */
class AscentTest {
  private static Hypothesis at(double a, double b) {
    Parameter first = Parameter.of("a", 0, -10, 10, 1);
    Parameter second = Parameter.of("b", 0, -10, 10, 1);
    Form form =
        new Form(Optional.empty(), "plane", List.of(first, second), v -> new RangeOffset(v[0]));
    return Hypothesis.NONE.and(form, a, b);
  }

  private static Ascent ascent(Function<double[], double[]> nats, double a, double b) {
    return new Ascent(set -> sum(nats.apply(set.values())), at(a, b), 0, new double[] {1, 1});
  }

  private static double square(double value) {
    return value * value;
  }

  /**
   * A straight line through 400 readings with normal scatter of 1: its top is that of least
   * squares.
   */
  private static double[] line(double a, double b) {
    Random random = new Random(3);
    double[] nats = new double[400];
    for (int i = 0; i < nats.length; i++) {
      double x = 1 + i / 100.0;
      nats[i] = -square(2 - x + random.nextGaussian() - a - b * x) / 2;
    }
    return nats;
  }

  private static double sum(double[] nats) {
    return Arrays.stream(nats).sum();
  }

  /** Offset and slope hang together by 0.94; the simplex takes three times as many evaluations. */
  @Test
  void parabola_isClimbedToItsTop() {
    int[] asked = new int[1];
    Ascent ascent =
        ascent(
            v -> {
              asked[0]++;
              return line(v[0], v[1]);
            },
            -1,
            3);
    Fit top = ascent.climb(0.02);
    assertTrue(ascent.isSmooth());
    double[] best = top.hypothesis().values();
    // Nowhere beside it is it higher by more than what ends the climb.
    for (double step : new double[] {-0.02, 0.02}) {
      assertTrue(sum(line(best[0] + step, best[1])) < top.logLikelihood() + 0.02);
      assertTrue(sum(line(best[0], best[1] + step)) < top.logLikelihood() + 0.02);
    }
    assertEquals(2, best[0], 0.5);
    assertEquals(-1, best[1], 0.2);
    assertTrue(asked[0] < 40, asked[0] + " evaluations");
  }

  /** The top lies outside: the nearest place that makes sense is taken. */
  @Test
  void values_stayInTheirIntervals() {
    Ascent ascent = ascent(v -> line(v[0] - 12, v[1]), 8, -1);
    assertEquals(10, ascent.climb(0.02).hypothesis().values()[0], 1e-9);
  }

  /** At an end of an interval that is a fiftieth of the scale: codes near 0 of a sensor of 4 m. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 0.013, 0.04})
  void narrowInterval_isClimbedFromAnyPlace(double start) {
    Parameter narrow = Parameter.of("code", 3, 0, 0.04, 0.0);
    Form form = new Form(Optional.empty(), "code", List.of(narrow), v -> new RangeOffset(v[0]));
    Ascent ascent =
        new Ascent(
            set -> -square(100 * (set.values()[0] - 0.03)),
            Hypothesis.NONE.and(form, start),
            0,
            new double[] {1});
    assertEquals(0.03, ascent.climb(1e-4).hypothesis().values()[0], 2e-3);
  }

  /** A value that says nothing alone, and much beside the other. */
  @Test
  void valuesThatOnlyMatterTogether_areClimbed() {
    Ascent ascent = ascent(v -> new double[] {-square(v[0] * v[1] - 1), 0, 0}, 0, 0);
    Fit top = ascent.climb(1e-4);
    assertTrue(top.logLikelihood() >= -1, top.toString());
    Arrays.stream(top.hypothesis().values()).forEach(v -> assertTrue(Double.isFinite(v)));
  }

  /** Of what gains nothing, or is the same everywhere, the start is the top. */
  @Test
  void flat_staysWhereItIs() {
    Ascent ascent = ascent(v -> new double[] {-5, 0, 0}, 1, 1);
    Fit top = ascent.climb(0.02);
    assertTrue(ascent.isSmooth());
    assertEquals(at(1, 1), top.hypothesis());
    assertEquals(-5, top.logLikelihood());
  }

  /** Steps of the likelihood follow no parabola, and it is never lower than at the start. */
  @Test
  void cliffs_areSaidToBeNoneOfItsKind() {
    DoubleUnaryOperator stairs = x -> 40 * Math.floor(3 * x) - 10 * x * x;
    Ascent ascent =
        ascent(v -> new double[] {stairs.applyAsDouble(v[0]), -square(v[1]), 0}, 0.1, 1);
    double start = stairs.applyAsDouble(0.1) - 1;
    assertTrue(ascent.climb(0.02).logLikelihood() >= start);
    assertFalse(ascent.isSmooth());
  }
}
