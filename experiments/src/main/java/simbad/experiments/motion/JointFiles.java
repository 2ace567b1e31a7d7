package simbad.experiments.motion;

import static simbad.gap.diagnosis.JsonFigures.interval;
import static simbad.gap.diagnosis.JsonFigures.put;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import simbad.experiments.diagnosis.DiagnosisFolder;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.AuditJson;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.DiagnosisJson;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.diagnosis.Estimate;
import simbad.gap.joint.JointDiagnosis;
import simbad.gap.joint.Shared;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionFolder;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;
import simbad.sonar.predict.FittedModel;

/**
 * What a diagnosis of a joint log leaves: one diagnosis.json, and the models of both halves, so
 * that the folder predicts readings and windows, and drives.
 */
public final class JointFiles {
  private static final String EFFECTS = "effects";
  private static final String PROBABILITY = "probability";

  private JointFiles() {}

  /**
   * Writes everything.
   *
   * @param folder exists and is empty
   * @param source the data set's own folder, whose scene and robot are copied
   * @param log what was diagnosed
   * @param diagnosis of it
   * @param provenance what it was made by
   * @return the fitted model of the sensors
   * @throws IOException if something cannot be written
   */
  public static FittedModel write(
      Path folder, Path source, Log log, JointDiagnosis diagnosis, DiagnosisProvenance provenance)
      throws IOException {
    FittedModel model =
        DiagnosisFolder.write(folder, source, log.data(), diagnosis.sensing(), provenance);
    MotionFiles.writeModel(folder, log.drive(), diagnosis.motion());
    WholeFile.write(
        folder.resolve(MotionFolder.ROBOT), Files.readAllBytes(source.resolve(MotionFolder.ROBOT)));
    TextFile.write(
        folder.resolve(DiagnosisJson.FILE), DiagnosisJson.text(tree(log, diagnosis, provenance)));
    return model;
  }

  /**
   * A joint log.
   *
   * @param data scene and readings
   * @param drive commands and track
   * @param audit what was found of readings, and then of commands and track
   */
  public record Log(DataSet data, MotionData drive, List<AuditFinding> audit) {
    /** Copies the list. */
    public Log {
      audit = List.copyOf(audit);
    }

    /** Returns how many rows of each kind there are. */
    private void addRows(ObjectNode rows) {
      rows.put("commands", drive.runs().stream().mapToInt(run -> run.commands().size()).sum());
      rows.put("track", drive.runs().stream().mapToInt(run -> run.track().size()).sum());
    }
  }

  /** The tree of the readings' half, with the whole's conclusions, and the motion's half in it. */
  private static ObjectNode tree(
      Log log, JointDiagnosis diagnosis, DiagnosisProvenance provenance) {
    ObjectNode root = DiagnosisJson.tree(diagnosis.sensing(), log.data(), provenance);
    root.put("about", "joint");
    List<AuditFinding> audit = new ArrayList<>(log.audit());
    audit.sort(Comparator.comparing(AuditFinding::severity).reversed());
    AuditJson.add(root.putArray("audit"), audit);
    root.put("verdict", diagnosis.verdict().word());
    root.put("reason", diagnosis.reason());
    ArrayNode names = root.putArray("explanation");
    diagnosis.explanation().forEach(names::add);
    put(root, "unknown_probability", diagnosis.unknownProbability());
    root.remove("verdict_probability");
    ObjectNode motion = root.putObject("motion");
    MotionFiles.conclude(motion, diagnosis.motion());
    root.set(EFFECTS, merged(root.path(EFFECTS), motion.remove(EFFECTS), diagnosis.shared()));
    motion.remove("explanation");
    motion.remove("unknown_probability");
    motion.remove("verdict_probability");
    ArrayNode shared = root.putArray("shared");
    diagnosis.shared().forEach(one -> add(shared.addObject(), one));
    log.addRows((ObjectNode) root.path("provenance").path("rows"));
    return root;
  }

  /** Both vocabularies, most probable first; what is heard of a shared cause says whose it is. */
  private static ArrayNode merged(JsonNode heard, JsonNode moved, List<Shared> shared) {
    List<ObjectNode> all = new ArrayList<>();
    heard.forEach(node -> all.add(((ObjectNode) node)));
    for (ObjectNode node : all) {
      shared.stream()
          .filter(one -> one.isOne() && one.isHeard())
          .filter(one -> one.effect().word().equals(node.path("name").asText()))
          .forEach(one -> node.put("one_cause_with", one.name()));
    }
    moved.forEach(node -> all.add((ObjectNode) node));
    all.sort(Comparator.comparingDouble(node -> -node.path(PROBABILITY).asDouble()));
    ArrayNode merged = all.get(0).arrayNode();
    all.forEach(merged::add);
    return merged;
  }

  private static void add(ObjectNode node, Shared shared) {
    node.put("name", shared.name());
    node.put("heard_as", shared.effect().word());
    node.put("parameter", shared.parameter());
    node.put("one_cause", shared.isOne());
    node.put("seen_by_tracker", shared.isTracked());
    node.put("heard_by_sonar", shared.isHeard());
    estimate(node.putObject("tracker"), shared.tracked());
    estimate(node.putObject("sonar"), shared.heard());
    if (shared.isOne()) {
      estimate(node.putObject("together"), shared.together());
    }
  }

  private static void estimate(ObjectNode node, Estimate estimate) {
    put(node, "value", estimate.value());
    interval(node.putArray("ci95"), estimate.ci95());
  }
}
