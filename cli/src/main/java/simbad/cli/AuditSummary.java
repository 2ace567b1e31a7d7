package simbad.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.List;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.AuditJson;

/**
 * A data set that was audited and not diagnosed, in one line.
 *
 * @param dataset the data set's name
 * @param audit what was found
 * @param folder where it was written
 */
record AuditSummary(String dataset, List<AuditFinding> audit, Path folder)
    implements DataSetSummary {
  AuditSummary {
    audit = List.copyOf(audit);
  }

  @Override
  public String line() {
    if (Audit.refuses(audit)) {
      return dataset + ": not diagnosed; as they stand, these data cannot be believed";
    }
    return dataset
        + ": "
        + (audit.isEmpty() ? "the audit found nothing" : "audited only, nothing was fitted");
  }

  @Override
  public String json() {
    ObjectNode node = new ObjectMapper().createObjectNode();
    node.put("dataset", dataset);
    AuditJson.add(node.putArray("audit"), audit);
    node.put("folder", folder.toString());
    return node.toString();
  }
}
