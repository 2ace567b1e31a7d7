package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.AuditFinding.File;
import simbad.gap.audit.Severity;

/** What an audit found, in words for console and page. */
public final class AuditWords {
  private AuditWords() {}

  /**
   * Returns a finding in a sentence without its full stop: what, and what to do.
   *
   * @param finding any
   */
  public static String sentence(AuditFinding finding) {
    return finding.what() + (finding.suggestion().isEmpty() ? "" : "; " + finding.suggestion());
  }

  /**
   * Returns the command that writes a mended copy.
   *
   * @param set the data set's folder as one would type it
   * @param findings all of its audit
   * @return empty where no transformation mends what is wrong
   */
  public static Optional<String> mendingCommand(String set, List<AuditFinding> findings) {
    Set<String> options = new LinkedHashSet<>();
    Set<File> files = new LinkedHashSet<>();
    for (AuditFinding finding : findings) {
      if (finding.severity() != Severity.NOTE && !finding.mend().isEmpty()) {
        options.add(finding.mend());
        files.add(finding.file());
      }
    }
    if (options.isEmpty()) {
      return Optional.empty();
    }
    List<String> words = new ArrayList<>(List.of("./simbad dataset mend", set, "--out"));
    words.add(set.replaceFirst("/+$", "") + "-mended");
    if (files.size() == 1) {
      words.add("--in " + files.iterator().next().fileName());
    }
    words.addAll(options);
    return Optional.of(String.join(" ", words));
  }
}
