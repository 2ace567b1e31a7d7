package simbad.experiments.motion;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializationFeature;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Provenance;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.gap.motion.MotionPlace;
import simbad.sonar.format.TextFile;

/** What a diagnosis of motion leaves: diagnosis.json and motion.json. */
public final class MotionFiles {
  private static final ObjectMapper MAPPER =
      new ObjectMapper().enable(SerializationFeature.INDENT_OUTPUT);

  private static final String[] HORIZONS = {"0.5", "2", "5"};
  private static final String[] COMPONENTS = {"along_m", "across_m", "turn_rad"};

  private MotionFiles() {}

  /**
   * Writes the files.
   *
   * @param folder that is there
   * @param dataset name of the data set
   * @param diagnosis of it
   * @param provenance what it was made of
   * @throws IOException if a file cannot be written
   */
  public static void write(
      Path folder, String dataset, MotionDiagnosis diagnosis, Provenance provenance)
      throws IOException {
    ObjectNode json = diagnosis(dataset, diagnosis);
    ObjectNode origin = json.putObject("provenance");
    provenance.sha256().forEach(origin.putObject("sha256")::put);
    origin.put("version", provenance.version());
    origin.put("windows", diagnosis.windows());
    TextFile.write(folder.resolve("diagnosis.json"), MAPPER.writeValueAsString(json) + "\n");
    TextFile.write(
        folder.resolve("motion.json"), MAPPER.writeValueAsString(model(diagnosis)) + "\n");
  }

  private static ObjectNode diagnosis(String dataset, MotionDiagnosis diagnosis) {
    ObjectNode json = MAPPER.createObjectNode();
    json.put("format", "sonar-diagnosis/2");
    json.put("dataset", dataset);
    json.put("verdict", diagnosis.verdict().word());
    json.put("headline", diagnosis.headline());
    ArrayNode names = json.putArray("explanation");
    diagnosis.findings().stream().map(MotionFinding::effect).distinct().forEach(names::add);
    ArrayNode effects = json.putArray("effects");
    diagnosis.findings().forEach(finding -> add(effects.addObject(), finding));
    json.put("unknown_probability", diagnosis.unknownProbability());
    gap(json.putObject("gap"), diagnosis);
    ArrayNode where = json.putArray("where");
    diagnosis.places().forEach(place -> add(where.addObject(), place));
    return json;
  }

  private static void add(ObjectNode node, MotionFinding finding) {
    node.put("name", finding.effect());
    node.put("form", finding.form());
    node.put("probability", finding.probability());
    ObjectNode values = node.putObject("parameters");
    ObjectNode intervals = node.putObject("ci95");
    for (MotionFinding.Parameter parameter : finding.parameters()) {
      values.put(parameter.name(), parameter.value());
      add(intervals.putArray(parameter.name()), parameter.ci95());
    }
    finding.ties().forEach(node.putArray("indistinguishable_from")::add);
    node.put("remedy", finding.remedy());
  }

  private static void add(ArrayNode node, Interval interval) {
    node.add(interval.low()).add(interval.high());
  }

  private static void gap(ObjectNode node, MotionDiagnosis diagnosis) {
    node.put("rows_held_out", diagnosis.windows());
    node.put("shrink", diagnosis.shrink());
    add(node.putArray("shrink_ci95"), diagnosis.shrinkCi95());
    ArrayNode horizons = node.putArray("horizons");
    for (int h = 0; h < HORIZONS.length; h++) {
      ObjectNode horizon = horizons.addObject();
      horizon.put("horizon_s", Double.parseDouble(HORIZONS[h]));
      for (int c = 0; c < COMPONENTS.length; c++) {
        ObjectNode component = horizon.putObject(COMPONENTS[c]);
        component.put("before", diagnosis.before()[h][c]);
        component.put("after", diagnosis.after()[h][c]);
      }
    }
  }

  private static void add(ObjectNode node, MotionPlace place) {
    node.putObject("slice").putArray(place.axis()).add(place.low()).add(place.high());
    node.put("rows", place.rows());
    node.put("share_of_gap", place.share());
    node.put("before", place.before());
    node.put("after", place.after());
  }

  private static ObjectNode model(MotionDiagnosis diagnosis) {
    ObjectNode json = MAPPER.createObjectNode();
    json.put("format", "motion-model/1");
    ArrayNode forms = json.putArray("forms");
    for (MotionFinding finding : diagnosis.findings()) {
      ObjectNode form = forms.addObject();
      form.put("form", finding.form());
      ObjectNode values = form.putObject("parameters");
      finding.parameters().forEach(one -> values.put(one.name(), one.value()));
    }
    return json;
  }
}
