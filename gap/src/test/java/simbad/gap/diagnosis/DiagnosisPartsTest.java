package simbad.gap.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.Severity;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;

/** The parts of a diagnosis, and what is derived from them. */
class DiagnosisPartsTest {
  private static final Diagnosis EXPLAINED = Samples.diagnosis(Verdict.EXPLAINED);

  private static Hypothesis set(Effect effect, String form, double... values) {
    Form of = Forms.find(effect, form, Samples.SETUP, List.of("s")).orElseThrow();
    return Hypothesis.NONE.and(of, values);
  }

  private static Diagnosis with(Hypothesis calibration, Optional<SetupError> error) {
    return with(EXPLAINED.explanation(), EXPLAINED.effects(), calibration, error);
  }

  private static Diagnosis with(
      List<Effect> named,
      List<EffectFinding> findings,
      Hypothesis calibration,
      Optional<SetupError> error) {
    Diagnosis d = EXPLAINED;
    return new Diagnosis(
        d.verdict(),
        d.reason(),
        named,
        findings,
        d.unknownProbability(),
        d.namedProbability(),
        d.atBound(),
        d.gap(),
        d.budget(),
        d.where(),
        d.undetectable(),
        d.nextExperiment(),
        d.fitted(),
        calibration,
        d.tried(),
        d.signs(),
        error,
        d.audit());
  }

  @Test
  void aHullHoldsBoth() {
    assertEquals(new Interval(-1, 5), new Interval(0, 5).hull(new Interval(-1, 3)));
    assertEquals(new Interval(-1, 5), new Interval(-1, 3).hull(new Interval(0, 5)));
    assertThrows(IllegalArgumentException.class, () -> new Interval(Double.NaN, 1));
    assertThrows(IllegalArgumentException.class, () -> new Interval(1, Double.NaN));
  }

  /** 1.96 standard deviations to either side. */
  @Test
  void anIntervalOfAnEstimateIsOf95PerCent() {
    Interval ci = new Estimate(3, 0.5).ci95();

    assertEquals(2.02, ci.low(), 1e-12);
    assertEquals(3.98, ci.high(), 1e-12);
    assertEquals(
        new FittedParameter("p", 3, ci), new FittedParameter("p", 3, new Interval(0, 1)).with(ci));
  }

  @Test
  void aDiagnosisIsToldOtherwiseInOnePartOnly() {
    Hypothesis gain = set(Effect.GAIN, "factor", 0.9);
    assertEquals(gain, EXPLAINED.with(gain).fitted());
    assertEquals(EXPLAINED.reason(), EXPLAINED.with(gain).reason());
    assertEquals(EXPLAINED, EXPLAINED.with(gain).with(EXPLAINED.fitted()));
    Diagnosis undecided = EXPLAINED.undecided("too few rows");
    assertEquals(Verdict.UNDECIDED, undecided.verdict());
    assertEquals("too few rows", undecided.reason());
    assertEquals(EXPLAINED.gap(), undecided.gap());
    assertEquals(EXPLAINED, EXPLAINED.with(List.of()));
  }

  @Test
  void theLawIsThatOfTheCalibration() {
    assertEquals(SensorLaw.Model.THRESHOLD, EXPLAINED.model());
    Form law = LevelForms.law(Samples.SETUP);
    Hypothesis level = EXPLAINED.calibration().and(law, law.neutral());
    assertEquals(SensorLaw.Model.LEVEL, with(level, Optional.empty()).model());
  }

  @Test
  void whatIsPartlyExplainedIsUnknownToo() {
    assertEquals(0.0625, EXPLAINED.probability(Verdict.PARTLY), 0);
    assertEquals(0.9375 * 0.96, EXPLAINED.probability(Verdict.EXPLAINED), 1e-12);
    assertEquals(0.9375 * 0.04, EXPLAINED.probability(Verdict.NONE), 1e-12);
  }

  /** 2.5 degrees less of half a radian. */
  @Test
  void aNamedEffectIsCorrectedInTheScene() {
    Hypothesis named =
        set(Effect.BEAM_WIDTH, "cone", -2.5)
            .and(set(Effect.RANGE_OFFSET, "constant", 0.1).forms().get(0), 0.1);
    CorrectedScene scene = CorrectedScene.of(Samples.SETUP, EXPLAINED.with(named));

    assertEquals(List.of(Effect.BEAM_WIDTH), scene.corrected());
    assertEquals(0.5 - Math.toRadians(2.5), scene.setup().sensor().coneHalfAngleRad(), 1e-12);
    assertEquals(List.of(Effect.RANGE_OFFSET), scene.elsewhere());
  }

  @Test
  void whatIsNotNamedIsNotCorrected() {
    Hypothesis named = set(Effect.BEAM_WIDTH, "cone", -2.5);
    SensingSetup stated = Samples.SETUP;
    CorrectedScene scene =
        CorrectedScene.of(stated, Samples.diagnosis(Verdict.UNEXPLAINED).with(named));

    assertSame(stated, scene.setup());
    assertEquals(List.of(), scene.corrected());
    assertEquals(List.of(), scene.elsewhere());
  }

  @Test
  void figuresHaveSixDigits() {
    ObjectNode node = new ObjectMapper().createObjectNode();
    JsonFigures.put(node, "third", 1000 / 3.0);
    JsonFigures.put(node, "endless", Double.NEGATIVE_INFINITY);
    ArrayNode ends = node.putArray("ends");
    JsonFigures.interval(ends, new Interval(Double.NEGATIVE_INFINITY, 2e-9 / 3));

    assertEquals(333.333, node.get("third").asDouble(), 0);
    assertTrue(node.get("endless").isNull());
    assertTrue(ends.get(0).isNull());
    assertEquals(6.66667e-10, ends.get(1).asDouble(), 0);
    assertEquals(-1.23457e8, JsonFigures.rounded(-123456789), 0);
  }

  @Test
  void whatASetupIsOffByStandsBesideItsLaw() {
    SetupError error = new SetupError(400, 2, 1.25, 1.5, 1.2, 3);
    ObjectNode root =
        DiagnosisJson.tree(
            with(EXPLAINED.calibration(), Optional.of(error)), Samples.DATA, Samples.PROVENANCE);

    JsonNode said = root.get("model_error");
    assertEquals(400, said.get("rows_held_out").asInt());
    assertEquals(2, said.get("gap_cm").asDouble());
    assertEquals(1.25, said.get("expected_cm").asDouble());
    assertEquals(1.5, said.get("echoes_vary").asDouble());
    assertEquals(1.2, said.get("ranges_vary").asDouble());
    assertEquals(3, said.get("misfit").asDouble());
    assertEquals("threshold", root.get("model").asText());
  }

  @Test
  void theRestOfTheFiguresStandWhereTheFormatSays() {
    JsonNode root = DiagnosisJson.tree(EXPLAINED, Samples.DATA, Samples.PROVENANCE);

    assertFalse(root.has("model_error"));
    assertEquals("by-hand", root.at("/dataset").asText());
    assertEquals(2, root.at("/gap/rows_held_out").asInt());
    assertEquals(3.2, root.at("/gap/before_cm").asDouble());
    assertEquals(1.6, root.at("/gap/after_cm").asDouble());
    assertEquals(1.5, root.at("/gap/floor_cm").asDouble());
    assertEquals(0.5, root.at("/gap/shrink").asDouble());
    assertEquals("rest", root.at("/budget/1/what").asText());
    assertEquals(0.1, root.at("/budget/1/cm").asDouble());
    assertEquals(0.3, root.at("/budget/1/ci95/1").asDouble());
    assertEquals(30, root.at("/where/0/rows").asInt());
    assertEquals(0.4, root.at("/where/0/share_of_gap").asDouble());
    assertEquals(9, root.at("/where/0/before_cm").asDouble());
    assertEquals(1, root.at("/where/0/after_cm").asDouble());
    assertEquals(1e-9, root.at("/where/0/q_value").asDouble());
    assertEquals("constant", root.at("/effects/0/form").asText());
    assertEquals("sound-speed", root.at("/effects/0/indistinguishable_from/0").asText());
    assertEquals("delay_s", root.at("/undetectable/1/parameter").asText());
    assertEquals(12.5, root.at("/next_experiment/expected_log_odds").asDouble());
    assertEquals("sound-speed", root.at("/next_experiment/separates/1").asText());
    assertTrue(root.at("/tried/1/behind_nats").isNull());
    assertEquals(0.25, root.at("/signs/misfit").asDouble());
    assertEquals("a".repeat(64), root.at("/provenance/sha256/readings.csv").asText());
    assertEquals(2, root.at("/provenance/rows/held_out").asInt());
    assertEquals(0, root.at("/provenance/rows/reference").asInt());
  }

  /** A log that no diagnosis was made of: nothing is held out. */
  @Test
  void anAuditAloneHasItsProvenance() throws IOException {
    String text = DiagnosisJson.text(List.of(), Samples.DATA, Samples.PROVENANCE);
    JsonNode root = new ObjectMapper().readTree(text);

    assertEquals("sonar-diagnosis/2", root.at("/format").asText());
    assertEquals("by-hand", root.at("/dataset").asText());
    assertEquals(0, root.at("/audit").size());
    assertEquals(0, root.at("/provenance/rows/held_out").asInt());
    assertEquals(7, root.at("/provenance/seed").asInt());
    assertFalse(root.has("verdict"));
  }

  /** Rows are counted from 1, and no more than twenty of them listed. */
  @Test
  void whatAnAuditFoundIsSaid() {
    List<Integer> rows = IntStream.range(4, 30).boxed().toList();
    AuditFinding plain =
        new AuditFinding(
            AuditCheck.UNIT,
            AuditFinding.File.READINGS,
            "too far",
            rows,
            "divide by 100",
            "",
            Severity.WARN);
    AuditFinding mended =
        new AuditFinding(
            AuditCheck.PILE,
            AuditFinding.File.REFERENCE,
            "piled up",
            List.of(),
            "leave out",
            "left out",
            Severity.NOTE);
    JsonNode audit =
        DiagnosisJson.tree(EXPLAINED.with(List.of(plain, mended)), Samples.DATA, Samples.PROVENANCE)
            .get("audit");

    assertEquals(2, audit.size());
    assertEquals("unit", audit.at("/0/check").asText());
    assertEquals("warn", audit.at("/0/severity").asText());
    assertEquals("readings.csv", audit.at("/0/file").asText());
    assertEquals("too far", audit.at("/0/what").asText());
    assertEquals(26, audit.at("/0/rows").asInt());
    assertEquals(20, audit.at("/0/first_rows").size());
    assertEquals(5, audit.at("/0/first_rows/0").asInt());
    assertEquals("divide by 100", audit.at("/0/suggestion").asText());
    assertFalse(audit.get(0).has("mend"));
    assertEquals("left out", audit.at("/1/mend").asText());
    assertEquals(0, audit.at("/1/first_rows").size());
  }

  private static EffectFinding finding(Effect effect, boolean fitted, Effect... ties) {
    Optional<String> form = fitted ? Optional.of("one") : Optional.empty();
    return new EffectFinding(effect, 0.5, form, List.of(), List.of(ties));
  }

  private static List<Effect> toActUpon(List<Effect> named, EffectFinding... findings) {
    Diagnosis other =
        with(named, List.of(findings), EXPLAINED.calibration(), EXPLAINED.setupError());
    return Remedies.toActUpon(other).stream().map(EffectFinding::effect).toList();
  }

  /** What cannot be told from the only name may be done as well, if it was fitted. */
  @Test
  void aTieOfTheOnlyNameIsToBeActedUponToo() {
    EffectFinding named = finding(Effect.GAIN, true, Effect.DROPOUT, Effect.LATENCY);
    EffectFinding tied = finding(Effect.DROPOUT, true);
    EffectFinding unfitted = finding(Effect.LATENCY, false);
    EffectFinding stranger = finding(Effect.RANGE_OFFSET, true);

    assertEquals(
        List.of(Effect.GAIN, Effect.DROPOUT),
        toActUpon(List.of(Effect.GAIN), stranger, tied, unfitted, named));
    assertEquals(
        List.of(Effect.RANGE_OFFSET, Effect.GAIN),
        toActUpon(List.of(Effect.GAIN, Effect.RANGE_OFFSET), stranger, tied, unfitted, named));
  }
}
