package simbad.gap.diagnosis;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import simbad.gap.audit.AuditFinding;

/** The findings of an audit as they stand in diagnosis.json. */
public final class AuditJson {
  /** So many rows are listed; how many there are is said beside them. */
  private static final int LISTED = 20;

  private AuditJson() {}

  /**
   * Adds findings to an array.
   *
   * @param array takes one object each
   * @param findings in their order
   */
  public static void add(ArrayNode array, List<AuditFinding> findings) {
    findings.forEach(finding -> add(array.addObject(), finding));
  }

  private static void add(ObjectNode node, AuditFinding finding) {
    node.put("check", finding.check().word());
    node.put("severity", finding.severity().word());
    node.put("file", finding.file().fileName());
    node.put("what", finding.what());
    node.put("rows", finding.rows().size());
    ArrayNode first = node.putArray("first_rows");
    // From 1, as people count the rows below the header.
    finding.rows().stream().limit(LISTED).forEach(row -> first.add(row + 1));
    node.put("suggestion", finding.suggestion());
    if (!finding.mend().isEmpty()) {
      node.put("mend", finding.mend());
    }
  }
}
