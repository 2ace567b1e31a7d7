package simbad.gap.audit;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.gap.audit.AuditFinding.File;

/** Readings of a drive at poses at which nobody can say what is in the cone. */
final class EdgeCheck {
  /** If so many are, what is left would be too little of the log to speak for it. */
  private static final double MOST_SHARE = 0.5;

  private EdgeCheck() {}

  static Optional<AuditFinding> of(AuditView view) {
    Set<Integer> unsure = UncertainPoses.rows(view.setup(), view.rows(), List.of());
    return unsure.isEmpty() || unsure.size() > MOST_SHARE * view.size()
        ? Optional.empty()
        : Optional.of(
            new AuditFinding(
                AuditCheck.EDGE,
                File.READINGS,
                Say.readings(unsure.size())
                    + " at poses that are not known well enough to say what is in the cone there",
                List.copyOf(unsure),
                "these rows are left out of all that follows",
                "",
                Severity.NOTE));
  }
}
