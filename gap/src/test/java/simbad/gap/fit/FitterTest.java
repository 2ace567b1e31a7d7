package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.sensing.ReadingRow;

/** Logs that a model drew are fitted by that model. */
class FitterTest {
  private static CalibratedLog drawn(Hypothesis truth, long seed) {
    List<ReadingRow> poses = Worlds.poses(1500, 0.3, 2.2, seed);
    return Worlds.given(Worlds.read(poses, truth, seed + 1));
  }

  /** Within about four standard errors of 1,500 readings, half of them echoes. */
  @ParameterizedTest
  @CsvSource({
    "gain, factor, 0.8, 1, 0.02",
    "range-offset, constant, 0.04, 0, 0.001",
    "sound-speed, scale, 360, 343, 0.5",
    "dropout, single, 0.3, 0.05, 0.07",
  })
  void refine_findsTheValueThatDrewTheLog(
      Effect effect, String form, double truth, double start, double tolerance) {
    CalibratedLog given = drawn(Worlds.effect(effect, form, truth), 3);
    Fit fit = new Fitter(given, Fold.ALL).refine(Worlds.effect(effect, form, start), 80);
    assertEquals(truth, fit.hypothesis().values()[0], tolerance);
    double atTruth = new Fitter(given, Fold.ALL).logLikelihood(Worlds.effect(effect, form, truth));
    assertTrue(fit.logLikelihood() >= atTruth - 0.5);
  }

  @Test
  void refine_neverLeavesTheIntervalAndNeverFallsBehindItsStart() {
    CalibratedLog given = drawn(Hypothesis.NONE, 5);
    Fitter fitter = new Fitter(given, Fold.ALL);
    Hypothesis start = Worlds.effect(Effect.GAIN, "factor", 2.9);
    Fit fit = fitter.refine(start, 60);
    assertTrue(fit.hypothesis().values()[0] <= 3);
    assertTrue(fit.logLikelihood() >= fitter.logLikelihood(start));
    assertEquals(start, fitter.refine(start, 0).hypothesis());
  }

  @Test
  void foldsAddUpToTheWhole() {
    CalibratedLog given = drawn(Hypothesis.NONE, 7);
    double even = new Fitter(given, ping -> ping % 2 == 0).logLikelihood(Hypothesis.NONE);
    double odd = new Fitter(given, ping -> ping % 2 == 1).logLikelihood(Hypothesis.NONE);
    double all = new Fitter(given, Fold.ALL).logLikelihood(Hypothesis.NONE);
    assertEquals(all, even + odd, 1e-9 * Math.abs(all));
  }

  @Test
  void jointFitter_addsTheReferenceAndTheLogWithItsEffects() {
    CalibratedLog reference = drawn(Hypothesis.NONE, 9);
    Hypothesis effects = Worlds.effect(Effect.GAIN, "factor", 0.8);
    CalibratedLog log = drawn(effects, 11);
    Hypothesis setup = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.01);
    double expected =
        new Fitter(reference, Fold.ALL).logLikelihood(setup)
            + new Fitter(log, Fold.ALL)
                .logLikelihood(setup.and(effects.forms().get(0), effects.values()));
    assertEquals(expected, new JointFitter(reference, log, effects).logLikelihood(setup), 1e-9);
  }

  /** Two bursts at once are no model: the effect's stands in the place of the set-up's. */
  @Test
  void jointFitter_takesTheMemoryOfTheEffects() {
    CalibratedLog reference = drawn(Hypothesis.NONE, 17);
    CalibratedLog log = drawn(Hypothesis.NONE, 19);
    Hypothesis effects = Worlds.effect(Effect.DROPOUT, "bursts", 0.3, 4);
    Hypothesis setup =
        Hypothesis.NONE.and(SetupForms.of(effects.forms().get(0)), new double[] {0.01, 2});
    double expected =
        new Fitter(reference, Fold.ALL).logLikelihood(setup)
            + new Fitter(log, Fold.ALL).logLikelihood(effects);
    assertEquals(expected, new JointFitter(reference, log, effects).logLikelihood(setup), 1e-9);
  }

  @ParameterizedTest
  @CsvSource({
    "near-clamp, clamp, 0.5",
    "obstacle-offset, all, 0.08 0.03",
    "unmodelled-object, post, 1 0.4 0.05 3 0.9 90",
    "coarse-resolution, nearest, 0.06",
    "coarse-resolution, centre, 0.08",
    "floor-echo, fixed, 0.9 0.01 0.5",
  })
  void screen_ranksTheEffectThatDrewTheLogFirst(Effect effect, String form, String values) {
    double[] truth = List.of(values.split(" ")).stream().mapToDouble(Double::parseDouble).toArray();
    CalibratedLog given = drawn(Worlds.effect(effect, form, truth), 13);
    Fit nominal = new Fitter(given, Fold.ALL).refine(Hypothesis.NONE, 0);
    // A whole table of thresholds, for which this post's are one, could take any shape.
    List<Form> forms =
        Forms.all(Worlds.POST, List.of("s")).stream()
            .filter(one -> one.effect() != Effect.ORIENTATION_SHADOW)
            .toList();
    Map<Effect, Fit> best = new Screen(given, nominal).all(forms);
    Fit first =
        best.values().stream().max(Comparator.comparingDouble(Fit::logLikelihood)).orElseThrow();
    assertEquals(List.of(effect), first.hypothesis().effects());
    assertEquals(truth[0], first.hypothesis().values()[0], 0.05 * Math.max(0.4, truth[0]));
  }
}
