package simbad.gap.diagnosis;

import static simbad.gap.diagnosis.JsonFigures.interval;
import static simbad.gap.diagnosis.JsonFigures.put;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.List;
import simbad.definition.Effect;
import simbad.gap.audit.AuditFinding;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.Form;
import simbad.sonar.scene.SonarSpec;

/**
 * A diagnosis as the text of diagnosis.json, {@code format} "sonar-diagnosis/2", rounded to six
 * digits; the ends of an interval that the data do not bound are null.
 */
public final class DiagnosisJson {
  /** The file's name in a diagnosis's folder. */
  public static final String FILE = "diagnosis.json";

  /** The version of the format that is written. */
  public static final String FORMAT = "sonar-diagnosis/2";

  /** The name of the file with the poses to measure next, beside it. */
  public static final String POSES = "next-experiment.csv";

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private DiagnosisJson() {}

  /**
   * Returns the text.
   *
   * @param diagnosis what was found
   * @param data what it was found in
   * @param provenance what it was made by
   */
  public static String text(Diagnosis diagnosis, DataSet data, DiagnosisProvenance provenance) {
    return text(tree(diagnosis, data, provenance));
  }

  /**
   * Returns the text for a data set that is audited and not diagnosed: it has no verdict.
   *
   * @param audit what was found
   * @param data what it was found in
   * @param provenance what it was made by
   */
  public static String text(
      List<AuditFinding> audit, DataSet data, DiagnosisProvenance provenance) {
    ObjectNode root = MAPPER.createObjectNode();
    root.put("format", FORMAT);
    root.put("dataset", data.name());
    AuditJson.add(root.putArray("audit"), audit);
    provenance(root.putObject("provenance"), 0, data, provenance);
    return text(root);
  }

  /** Returns a tree as the text of a file. */
  public static String text(ObjectNode root) {
    DefaultIndenter lines = new DefaultIndenter("  ", "\n");
    try {
      return MAPPER
              .writer(new DefaultPrettyPrinter().withObjectIndenter(lines))
              .writeValueAsString(root)
          + "\n";
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Returns what {@link #text} writes.
   *
   * @param diagnosis what was found
   * @param data what it was found in
   * @param provenance what it was made by
   */
  public static ObjectNode tree(Diagnosis diagnosis, DataSet data, DiagnosisProvenance provenance) {
    ObjectNode root = MAPPER.createObjectNode();
    root.put("format", FORMAT);
    root.put("dataset", data.name());
    AuditJson.add(root.putArray("audit"), diagnosis.audit());
    root.put("verdict", diagnosis.verdict().word());
    if (!diagnosis.reason().isEmpty()) {
      root.put("reason", diagnosis.reason());
    }
    words(root.putArray("explanation"), diagnosis.explanation());
    put(root, "unknown_probability", diagnosis.unknownProbability());
    verdicts(root.putObject("verdict_probability"), diagnosis);
    ArrayNode atBound = root.putArray("at_bound");
    diagnosis.atBound().forEach(one -> atBound(atBound.addObject(), one));
    gap(root.putObject("gap"), diagnosis.gap());
    root.put("model", diagnosis.model().word());
    diagnosis.setupError().ifPresent(error -> setupError(root.putObject("model_error"), error));
    ArrayNode budget = root.putArray("budget");
    diagnosis.budget().forEach(entry -> budget(budget.addObject(), entry));
    effects(root.putArray("effects"), diagnosis, data.setup().sensor());
    ArrayNode where = root.putArray("where");
    diagnosis.where().forEach(place -> place(where.addObject(), place));
    ArrayNode undetectable = root.putArray("undetectable");
    diagnosis.undetectable().forEach(one -> undetectable(undetectable.addObject(), one));
    diagnosis.nextExperiment().ifPresent(next -> next(root.putObject("next_experiment"), next));
    calibration(root.putObject("calibration"), diagnosis.calibration());
    ArrayNode tried = root.putArray("tried");
    diagnosis.tried().forEach(attempt -> attempt(tried.addObject(), attempt));
    ObjectNode signs = root.putObject("signs");
    diagnosis.signs().forEach((name, value) -> put(signs, name, value));
    int heldOut = diagnosis.gap().rowsHeldOut();
    provenance(root.putObject("provenance"), heldOut, data, provenance);
    return root;
  }

  private static void effects(ArrayNode all, Diagnosis diagnosis, SonarSpec sensor) {
    List<EffectFinding> toActUpon = Remedies.toActUpon(diagnosis);
    for (EffectFinding finding : diagnosis.effects()) {
      ObjectNode node = all.addObject();
      effect(node, finding);
      if (toActUpon.contains(finding)) {
        node.put("remedy", Remedies.of(finding, sensor));
      }
    }
  }

  private static void verdicts(ObjectNode node, Diagnosis diagnosis) {
    for (Verdict verdict : Verdict.TRUTHS) {
      put(node, verdict.word(), diagnosis.probability(verdict));
    }
  }

  private static void atBound(ObjectNode node, AtBound one) {
    node.put("effect", one.effect().word());
    node.put("parameter", one.parameter());
    put(node, "value", one.value());
    interval(node.putArray("allowed"), one.allowed());
  }

  private static void gap(ObjectNode node, GapFigures gap) {
    node.put("rows_held_out", gap.rowsHeldOut());
    put(node, "before_cm", gap.beforeCm());
    put(node, "after_cm", gap.afterCm());
    put(node, "floor_cm", gap.floorCm());
    put(node, "shrink", gap.shrink());
    interval(node.putArray("shrink_ci95"), gap.shrinkCi95());
  }

  private static void budget(ObjectNode node, BudgetEntry entry) {
    node.put("what", entry.what());
    put(node, "cm", entry.cm());
    interval(node.putArray("ci95"), entry.ci95());
  }

  private static void setupError(ObjectNode node, SetupError error) {
    node.put("rows_held_out", error.rows());
    put(node, "gap_cm", error.gapCm());
    put(node, "expected_cm", error.expectedCm());
    put(node, "echoes_vary", error.echoes());
    put(node, "ranges_vary", error.ranges());
    put(node, "misfit", error.misfit());
  }

  private static void effect(ObjectNode node, EffectFinding finding) {
    node.put("name", finding.effect().word());
    put(node, "probability", finding.probability());
    finding.form().ifPresent(form -> node.put("form", form));
    ObjectNode values = node.putObject("parameters");
    ObjectNode intervals = node.putObject("ci95");
    for (FittedParameter parameter : finding.parameters()) {
      put(values, parameter.name(), parameter.value());
      interval(intervals.putArray(parameter.name()), parameter.ci95());
    }
    words(node.putArray("indistinguishable_from"), finding.indistinguishableFrom());
  }

  private static void place(ObjectNode node, Place place) {
    ObjectNode slice = node.putObject("slice");
    for (Place.Condition condition : place.conditions()) {
      condition.name().ifPresent(name -> slice.put(condition.variable(), name));
      condition.interval().ifPresent(ends -> interval(slice.putArray(condition.variable()), ends));
    }
    node.put("rows", place.rows());
    put(node, "share_of_gap", place.shareOfGap());
    put(node, "before_cm", place.beforeCm());
    put(node, "after_cm", place.afterCm());
    node.put("kind", place.kind().words());
    put(node, "q_value", place.qValue());
  }

  private static void undetectable(ObjectNode node, Undetectable one) {
    node.put("name", one.effect().word());
    node.put("parameter", one.parameter());
    if (one.leastSize().isPresent()) {
      put(node, "least_size", one.leastSize().getAsDouble());
    } else {
      node.putNull("least_size");
    }
  }

  private static void next(ObjectNode node, NextExperiment next) {
    words(node.putArray("separates"), next.separates());
    node.put("poses", POSES);
    put(node, "expected_log_odds", next.expectedLogOdds());
  }

  /** What the reference showed of the set-up: by form, its values by name. */
  private static void calibration(ObjectNode node, Hypothesis calibration) {
    for (int i = 0; i < calibration.forms().size(); i++) {
      Form form = calibration.forms().get(i);
      double[] values = calibration.valuesOf(i);
      ObjectNode own = node.putObject(form.name());
      for (int p = 0; p < values.length; p++) {
        put(own, form.parameters().get(p).name(), values[p]);
      }
    }
  }

  private static void attempt(ObjectNode node, Diagnosis.Attempt attempt) {
    words(node.putArray("effects"), attempt.effects());
    put(node, "held_out_nats", attempt.heldOutNats());
    put(node, "behind_nats", attempt.behindNats());
  }

  private static void provenance(
      ObjectNode node, int heldOut, DataSet data, DiagnosisProvenance provenance) {
    ObjectNode hashes = node.putObject("sha256");
    provenance.sha256().forEach(hashes::put);
    node.put("version", provenance.version());
    node.put("seed", provenance.seed());
    ObjectNode rows = node.putObject("rows");
    rows.put("readings", data.readings().size());
    rows.put("reference", data.reference().size());
    rows.put("held_out", heldOut);
  }

  private static void words(ArrayNode array, Collection<Effect> effects) {
    effects.forEach(effect -> array.add(effect.word()));
  }
}
