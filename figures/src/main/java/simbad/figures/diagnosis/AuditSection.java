package simbad.figures.diagnosis;

import java.util.List;
import simbad.figures.markup.Markup;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditFinding;

/** The audit on a page: it comes first, for what follows is of data that may be wrong. */
final class AuditSection {
  private AuditSection() {}

  /** Adds the findings, and nothing where there are none. */
  static void add(StringBuilder page, List<AuditFinding> findings, String dataset) {
    if (findings.isEmpty()) {
      return;
    }
    page.append(
        "<section class=\"panel\" id=\"audit\"><h3>What is wrong with the data</h3>\n<ul>\n");
    for (AuditFinding finding : findings) {
      page.append(
          "<li><strong>"
              + finding.severity().word()
              + "</strong>, "
              + finding.file().fileName()
              + first(finding)
              + ": "
              + Markup.escaped(AuditWords.sentence(finding))
              + ".</li>\n");
    }
    page.append("</ul>\n");
    AuditWords.mendingCommand(dataset, findings)
        .ifPresent(
            command ->
                page.append(
                    "<p>A mended copy: <code>" + Markup.escaped(command) + "</code></p>\n"));
    page.append("</section>\n");
  }

  /** From where on; rows are counted from 1 below the file's head. */
  private static String first(AuditFinding finding) {
    return finding.rows().isEmpty() ? "" : " from row " + (finding.rows().get(0) + 1) + " on";
  }

  /** A page of the audit alone. */
  static String page(String dataset, List<AuditFinding> findings) {
    String name = Markup.escaped(dataset);
    StringBuilder page = new StringBuilder(Style.head(name + ": audit"));
    page.append("<h1>Simulation and reality: " + name + "</h1>\n");
    page.append("<p class=\"verdict\">" + verdict(findings) + "</p>\n");
    add(page, findings, dataset);
    return page.append("</main>\n</body>\n</html>\n").toString();
  }

  private static String verdict(List<AuditFinding> findings) {
    if (findings.isEmpty()) {
      return "<strong>Nothing found:</strong> these data can be what they are said to be.";
    }
    return Audit.refuses(findings)
        ? "<strong>Not diagnosed:</strong> as they stand, these data cannot be believed."
        : "<strong>Audited only:</strong> nothing was fitted.";
  }
}
