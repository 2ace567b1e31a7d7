package simbad.cli;

import java.nio.file.Path;
import java.util.List;
import simbad.gap.audit.AuditFinding;

/** What is said on the console of a data set. */
sealed interface DataSetSummary permits DiagnoseSummary, AuditSummary, MotionSummary, JointSummary {
  /** Returns where it was written. */
  Path folder();

  /** Returns what the audit found. */
  List<AuditFinding> audit();

  /** Returns it in one line for people. */
  String line();

  /** Returns it as one object on one line for programs. */
  String json();
}
