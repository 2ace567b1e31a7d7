package simbad.figures.diagnosis;

import java.util.List;
import simbad.figures.page.Html;
import simbad.figures.page.Page;
import simbad.gap.audit.Audit;
import simbad.gap.audit.AuditFinding;

/** The audit on a page: it comes first, for what follows is of data that may be wrong. */
final class AuditSection {
  private AuditSection() {}

  /** Adds the findings, and nothing where there are none. */
  static void add(Page page, List<AuditFinding> findings, String dataset) {
    if (findings.isEmpty()) {
      return;
    }
    Html items = Page.listed(findings.stream().map(AuditSection::item).toList());
    Html mending =
        AuditWords.mendingCommand(dataset, findings)
            .map(
                command ->
                    Html.styled(
                        "p",
                        "soft",
                        "A mended copy (" + dataset + " stands for the folder of the data set): ",
                        Html.code(command)))
            .orElse(Html.NONE);
    page.add(Page.panel("audit", "Problems in the data", items, mending));
  }

  private static Html item(AuditFinding finding) {
    return Html.of(
        Html.strong(finding.severity().word()),
        ", ",
        finding.file().fileName(),
        first(finding),
        ": ",
        AuditWords.sentence(finding),
        ".");
  }

  /** From where on; rows are counted from 1 below the file's head. */
  private static String first(AuditFinding finding) {
    return finding.rows().isEmpty() ? "" : " from row " + (finding.rows().get(0) + 1) + " on";
  }

  /** A page of the audit alone. */
  static String page(String dataset, List<AuditFinding> findings) {
    Page page = new Page(dataset + ": audit", "Simulation and reality: " + dataset);
    page.verdict(verdict(findings));
    add(page, findings, dataset);
    return page.html();
  }

  private static Html verdict(List<AuditFinding> findings) {
    if (findings.isEmpty()) {
      return said("Nothing found:", " nothing speaks against these data.");
    }
    return Audit.refuses(findings)
        ? said("Not diagnosed:", " as they stand, these data cannot be believed.")
        : said("Audited only:", " nothing was fitted.");
  }

  private static Html said(String first, String rest) {
    return Html.of(Html.strong(first), rest);
  }
}
