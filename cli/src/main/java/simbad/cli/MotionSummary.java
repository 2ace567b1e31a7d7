package simbad.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.List;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.AuditJson;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;

/**
 * A diagnosis of motion in one line.
 *
 * @param dataset the data set's name
 * @param audit what was found of the data
 * @param diagnosis of it
 * @param folder where it was written
 */
record MotionSummary(
    String dataset, List<AuditFinding> audit, MotionDiagnosis diagnosis, Path folder)
    implements DataSetSummary {
  MotionSummary {
    audit = List.copyOf(audit);
  }

  @Override
  public String line() {
    return dataset + ": " + diagnosis.verdict().word() + "; " + diagnosis.headline();
  }

  @Override
  public String json() {
    ObjectNode node = new ObjectMapper().createObjectNode();
    node.put("dataset", dataset);
    AuditJson.add(node.putArray("audit"), audit());
    node.put("verdict", diagnosis.verdict().word());
    diagnosis.findings().stream()
        .map(MotionFinding::effect)
        .distinct()
        .forEach(node.putArray("explanation")::add);
    node.put("shrink", diagnosis.gap().shrink());
    node.put("folder", folder.toString());
    return node.toString();
  }
}
