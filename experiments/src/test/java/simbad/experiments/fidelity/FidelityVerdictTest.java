package simbad.experiments.fidelity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.experiments.run.Experiment;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.RunSettings;
import simbad.experiments.run.SensorKind;
import simbad.obstacles.Catalogue;
import simbad.sonar.model.DetectionRule;

class FidelityVerdictTest {
  private static RunResult run(SensorKind sensor) {
    return Experiment.run(
            new RunSettings(
                List.of(Catalogue.find("round").orElseThrow()),
                List.of(sensor),
                Catalogue.srf04(),
                0.1,
                Optional.empty(),
                1),
            result -> {})
        .get(0);
  }

  /** It hears up to 2.5 m what the table loses at 2 m: half a metre off, all round. */
  @Test
  void originalSensor_isNotFaithful() {
    FidelityVerdict verdict = FidelityVerdict.of(run(SensorKind.ORIGINAL), FidelityLimits.STANDARD);
    assertFalse(verdict.passes());
    assertTrue(verdict.sentence().contains("radial error 51."), verdict.sentence());
    assertTrue(verdict.sentence().contains("% of the poses"), verdict.sentence());
  }

  /** The same run passes or fails by what is asked of it. */
  @Test
  void limits_decide() {
    RunResult result = run(SensorKind.of("mine", DetectionRule.SHADOW));
    assertTrue(FidelityVerdict.of(result, FidelityLimits.STANDARD).passes());
    FidelityVerdict strict = FidelityVerdict.of(result, new FidelityLimits(1, 0, 0, 0));
    assertTrue(strict.failings().size() >= 2, strict.sentence());
  }

  /** As the page shows them: each limit, what was asked for and what was reached. */
  @Test
  void checks_nameEveryLimit() {
    List<LimitCheck> checks =
        FidelityVerdict.of(run(SensorKind.ORIGINAL), new FidelityLimits(0.985, 0.03, 9, 0))
            .checks();
    assertEquals(
        List.of(
            "yes",
            "at least 98.5 %",
            "at most 3 cm",
            "at most 900 cm",
            "at most 0",
            "at least 95 %"),
        checks.stream().map(LimitCheck::limit).toList());
    assertEquals(
        List.of(true, false, false, true, true, false),
        checks.stream().map(LimitCheck::isHeld).toList());
    assertEquals("0 of 72", checks.get(4).reached());
    assertEquals("0.0 %", checks.get(5).reached());
  }

  @Test
  void impossibleLimits_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> new FidelityLimits(1.1, 0, 0, 0));
    assertThrows(IllegalArgumentException.class, () -> new FidelityLimits(1, Double.NaN, 0, 0));
  }
}
