package simbad.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.List;
import simbad.experiments.motion.JointFiles;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.AuditJson;
import simbad.gap.joint.JointDiagnosis;

/**
 * The diagnosis of a joint log in one line.
 *
 * @param log what was diagnosed
 * @param diagnosis of it
 * @param folder where it was written
 */
record JointSummary(JointFiles.Log log, JointDiagnosis diagnosis, Path folder)
    implements DataSetSummary {
  @Override
  public List<AuditFinding> audit() {
    return log.audit();
  }

  @Override
  public String line() {
    String names = String.join(" + ", diagnosis.explanation());
    return log.data().name()
        + ": "
        + diagnosis.verdict().word()
        + (names.isEmpty() ? "" : ", " + names)
        + "; "
        + diagnosis.reason();
  }

  @Override
  public String json() {
    ObjectNode node = new ObjectMapper().createObjectNode();
    node.put("dataset", log.data().name());
    AuditJson.add(node.putArray("audit"), audit());
    node.put("verdict", diagnosis.verdict().word());
    diagnosis.explanation().forEach(node.putArray("explanation")::add);
    node.put("reason", diagnosis.reason());
    node.put("shrink", diagnosis.sensing().gap().shrink());
    node.put("motion_shrink", diagnosis.motion().gap().shrink());
    node.put("folder", folder.toString());
    return node.toString();
  }
}
