package simbad.cli;

import java.nio.file.Path;
import java.util.List;
import simbad.figures.diagnosis.AuditWords;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.gap.audit.AuditFinding.File;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * The findings of an audit as lines that name file, line and field.
 *
 * @param folder of the data set, as it was given
 * @param findings of its audit
 */
record AuditLines(Path folder, List<AuditFinding> findings) {
  AuditLines {
    findings = List.copyOf(findings);
  }

  /** A finding as a complaint. */
  DataFormatException complaint(AuditFinding finding) throws DataFormatException {
    String command =
        finding.refuses()
            ? AuditWords.mendingCommand(folder.toString(), findings).map(c -> "; " + c).orElse("")
            : "";
    return DataFormatException.inField(
        folder.resolve(finding.file().fileName()),
        line(finding),
        field(finding),
        AuditWords.sentence(finding) + command);
  }

  /** A finding of the times may be one of what the scene says of them. */
  private static String field(AuditFinding finding) {
    return finding.file() == File.SCENE && finding.check() == AuditCheck.PERIOD
        ? inScene(finding)
        : finding.check().field();
  }

  private static String inScene(AuditFinding finding) {
    return finding.what().split(" ", 2)[0];
  }

  /** The line of the first row that shows it; that of the field in a scene. */
  private long line(AuditFinding finding) throws DataFormatException {
    Path file = folder.resolve(finding.file().fileName());
    String text = TextFile.read(file);
    if (finding.file() == File.SCENE) {
      String field = inScene(finding);
      String before = text.substring(0, Math.max(0, text.indexOf("\"" + field + "\"")));
      return 1 + before.chars().filter(c -> c == '\n').count();
    }
    return finding.rows().isEmpty() ? 1 : CsvTable.parse(file, text).line(finding.rows().get(0));
  }
}
