package simbad.experiments.motion;

import static simbad.gap.diagnosis.JsonFigures.interval;
import static simbad.gap.diagnosis.JsonFigures.put;
import static simbad.gap.diagnosis.JsonFigures.rounded;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.AuditJson;
import simbad.gap.diagnosis.DiagnosisJson;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.gap.motion.MotionPlace;
import simbad.motion.CommandReach;
import simbad.motion.Robot;
import simbad.motion.forecast.Windows;
import simbad.motion.format.DiagnosedMotion;
import simbad.motion.format.MotionData;
import simbad.sonar.format.TextFile;

/** What a diagnosis of motion leaves: diagnosis.json, motion.json, the next drive. */
public final class MotionFiles {
  /** Commands that would tell tied effects apart. */
  public static final String NEXT = "next-commands.csv";

  private static final ObjectMapper MAPPER =
      new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

  private static final String[] COMPONENTS = {"along_m", "across_m", "turn_rad"};

  private MotionFiles() {}

  /**
   * Writes the files.
   *
   * @param folder that is there
   * @param data what was diagnosed
   * @param audit what was found of the data
   * @param diagnosis of it
   * @param provenance what it was made of
   * @throws IOException if a file cannot be written
   */
  public static void write(
      Path folder,
      MotionData data,
      List<AuditFinding> audit,
      MotionDiagnosis diagnosis,
      DiagnosisProvenance provenance)
      throws IOException {
    ObjectNode json = head(data, audit);
    conclude(json, diagnosis);
    provenance(json.putObject("provenance"), data, provenance, diagnosis.gap().windows());
    write(folder, json);
    writeModel(folder, data, diagnosis);
  }

  /** Writes what a robot can be driven with, and the next drive where there is one. */
  static void writeModel(Path folder, MotionData data, MotionDiagnosis diagnosis)
      throws IOException {
    TextFile.write(
        folder.resolve(DiagnosedMotion.MODEL),
        DiagnosedMotion.text(
            diagnosis.fitted(), diagnosis.forecast().spreads(), CommandReach.of(data.runs())));
    if (diagnosis.next().isPresent()) {
      TextFile.write(folder.resolve(NEXT), next(data.robot(), diagnosis.next().get()));
    }
  }

  /**
   * Writes what the audit found where nothing was fitted.
   *
   * @param folder that is there
   * @param data what was audited
   * @param audit what was found
   * @param provenance what it was made of
   * @throws IOException if a file cannot be written
   */
  public static void write(
      Path folder, MotionData data, List<AuditFinding> audit, DiagnosisProvenance provenance)
      throws IOException {
    ObjectNode json = head(data, audit);
    provenance(json.putObject("provenance"), data, provenance, 0);
    write(folder, json);
  }

  private static void write(Path folder, ObjectNode json) throws IOException {
    TextFile.write(folder.resolve(DiagnosisJson.FILE), MAPPER.writeValueAsString(json) + "\n");
  }

  private static ObjectNode head(MotionData data, List<AuditFinding> audit) {
    ObjectNode json = MAPPER.createObjectNode();
    json.put("format", DiagnosisJson.FORMAT);
    json.put("about", "motion");
    json.put("dataset", data.name());
    AuditJson.add(json.putArray("audit"), audit);
    return json;
  }

  private static void provenance(
      ObjectNode node, MotionData data, DiagnosisProvenance provenance, int windows) {
    provenance.sha256().forEach(node.putObject("sha256")::put);
    node.put("version", provenance.version());
    node.put("seed", provenance.seed());
    ObjectNode rows = node.putObject("rows");
    rows.put("commands", data.runs().stream().mapToInt(run -> run.commands().size()).sum());
    rows.put("track", data.runs().stream().mapToInt(run -> run.track().size()).sum());
    rows.put("reference", data.reference().stream().mapToInt(run -> run.track().size()).sum());
    rows.put("held_out", windows);
  }

  /** Says all that a diagnosis concludes. */
  static void conclude(ObjectNode json, MotionDiagnosis diagnosis) {
    json.put("verdict", diagnosis.verdict().word());
    json.put("reason", diagnosis.headline());
    ArrayNode names = json.putArray("explanation");
    diagnosis.findings().stream().map(MotionFinding::effect).forEach(names::add);
    put(json, "unknown_probability", diagnosis.unknownProbability());
    if (!diagnosis.signs().isEmpty()) {
      ObjectNode verdicts = json.putObject("verdict_probability");
      for (Verdict verdict : Verdict.TRUTHS) {
        put(verdicts, verdict.word(), diagnosis.probability(verdict));
      }
    }
    ArrayNode bounds = json.putArray("at_bound");
    diagnosis.findings().forEach(finding -> atBound(bounds, finding));
    gap(json.putObject("gap"), diagnosis.gap());
    ArrayNode budget = json.putArray("budget");
    diagnosis.budget().forEach(part -> add(budget.addObject(), part));
    ArrayNode effects = json.putArray("effects");
    diagnosis.findings().forEach(finding -> add(effects.addObject(), finding));
    diagnosis.others().forEach(finding -> add(effects.addObject(), finding));
    ArrayNode where = json.putArray("where");
    diagnosis.places().forEach(place -> add(where.addObject(), place));
    ArrayNode hidden = json.putArray("undetectable");
    diagnosis.undetectable().forEach(one -> add(hidden.addObject(), one));
    diagnosis.next().ifPresent(next -> add(json.putObject("next_experiment"), next));
    ObjectNode signs = json.putObject("signs");
    diagnosis.signs().forEach((name, value) -> put(signs, name, value));
  }

  private static void atBound(ArrayNode bounds, MotionFinding finding) {
    for (MotionFinding.Parameter parameter : finding.parameters()) {
      if (parameter.atBound()) {
        ObjectNode node = bounds.addObject();
        node.put("effect", finding.effect());
        node.put("parameter", parameter.name());
        put(node, "value", parameter.value());
        interval(node.putArray("allowed"), parameter.allowed());
      }
    }
  }

  private static void add(ObjectNode node, MotionFinding finding) {
    node.put("name", finding.effect());
    put(node, "probability", finding.probability());
    if (!finding.form().isEmpty()) {
      node.put("form", finding.form());
    }
    ObjectNode values = node.putObject("parameters");
    ObjectNode intervals = node.putObject("ci95");
    for (MotionFinding.Parameter parameter : finding.parameters()) {
      put(values, parameter.name(), parameter.value());
      interval(intervals.putArray(parameter.name()), parameter.ci95());
    }
    if (!finding.remedy().isEmpty()) {
      node.put("remedy", finding.remedy());
    }
    finding.ties().forEach(node.putArray("indistinguishable_from")::add);
  }

  private static void gap(ObjectNode node, MotionDiagnosis.Gap gap) {
    node.put("rows_held_out", gap.windows());
    put(node, "before", 1);
    put(node, "after", gap.ratio());
    put(node, "floor", gap.floor());
    put(node, "shrink", gap.shrink());
    interval(node.putArray("shrink_ci95"), gap.shrinkCi95());
    interval(node.putArray("shrink_of_this_log_ci95"), gap.shrinkHere95());
    ArrayNode horizons = node.putArray("horizons");
    for (int h = 0; h < Windows.horizonsS().length; h++) {
      ObjectNode horizon = horizons.addObject();
      horizon.put("horizon_s", Windows.horizonsS()[h]);
      for (int c = 0; c < COMPONENTS.length; c++) {
        ObjectNode component = horizon.putObject(COMPONENTS[c]);
        put(component, "before", gap.before()[h][c]);
        put(component, "after", gap.after()[h][c]);
        put(component, "within_90", gap.coverage()[h][c]);
      }
    }
  }

  private static void add(ObjectNode node, MotionDiagnosis.Part part) {
    node.put("what", part.what());
    put(node, "share", part.share());
    interval(node.putArray("ci95"), part.ci95());
  }

  private static void add(ObjectNode node, MotionPlace place) {
    ObjectNode slice = node.putObject("slice");
    if (place.name().isEmpty()) {
      interval(slice.putArray(place.axis()), new Interval(place.low(), place.high()));
    } else {
      slice.put(place.axis(), place.name());
    }
    node.put("rows", place.rows());
    put(node, "share_of_gap", place.share());
    put(node, "before", place.before());
    put(node, "after", place.after());
    node.put("kind", place.component());
    put(node, "q_value", place.qValue());
  }

  private static void add(ObjectNode node, MotionDiagnosis.Hidden hidden) {
    node.put("name", hidden.effect());
    node.put("parameter", hidden.parameter());
    put(node, "least_size", hidden.leastSize());
  }

  private static void add(ObjectNode node, MotionDiagnosis.NextDrive next) {
    next.separates().forEach(node.putArray("separates")::add);
    node.put("commands", NEXT);
    put(node, "expected_log_odds", next.expectedLogOdds());
  }

  private static String next(Robot robot, MotionDiagnosis.NextDrive next) {
    List<String> columns =
        robot.differential() ? List.of("left_m_s", "right_m_s") : List.of("v_m_s", "w_rad_s");
    StringBuilder text = new StringBuilder("run,t_s," + String.join(",", columns) + "\n");
    double half = robot.wheelBaseM() / 2;
    next.commands()
        .forEach(
            c -> {
              double first = c.speedMPerS() - half * c.turnRadPerS();
              double second = c.speedMPerS() + half * c.turnRadPerS();
              text.append("next,").append(rounded(c.timeS())).append(',');
              text.append(rounded(robot.differential() ? first : c.speedMPerS())).append(',');
              text.append(rounded(robot.differential() ? second : c.turnRadPerS())).append('\n');
            });
    return text.toString();
  }
}
