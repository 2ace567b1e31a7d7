package simbad.gap.audit;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.gap.audit.AuditFinding.File;

/** Readings at poses at which nobody can say what is in the cone. */
final class EdgeCheck {
  private EdgeCheck() {}

  static Optional<AuditFinding> of(AuditView view) {
    Set<Integer> unsure = UncertainPoses.rows(view.setup(), view.rows(), List.of());
    return unsure.isEmpty()
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
