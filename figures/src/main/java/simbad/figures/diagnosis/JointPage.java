package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import simbad.experiments.motion.JointFiles;
import simbad.figures.page.Html;
import simbad.figures.page.Page;
import simbad.figures.page.Table;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.diagnosis.Estimate;
import simbad.gap.joint.JointDiagnosis;
import simbad.gap.joint.Shared;

/** The page of a joint log: what both halves say together, then each half as on its own page. */
final class JointPage {
  private final Page page;
  private final JointDiagnosis diagnosis;

  private JointPage(Page page, JointDiagnosis diagnosis) {
    this.page = page;
    this.diagnosis = diagnosis;
  }

  /**
   * Returns the page as HTML.
   *
   * @param log what was diagnosed
   * @param diagnosis of it
   * @param rows all rows before and after; at least one
   * @param provenance what it was made by
   */
  static String of(
      JointFiles.Log log,
      JointDiagnosis diagnosis,
      List<RowFinding> rows,
      DiagnosisProvenance provenance) {
    String name = log.data().name();
    String verdict = diagnosis.verdict().word();
    Page page = new Page(name + ": " + verdict, "What the robot hears and how it moves: " + name);
    JointPage own = new JointPage(page, diagnosis);
    own.answer();
    AuditSection.add(page, log.audit(), name);
    own.shared();
    page.section("The readings");
    DiagnosisPage.add(page, diagnosis.sensing(), log.data(), rows);
    page.section("The motion");
    page.say(
        Html.strong(diagnosis.motion().verdict().word()), ": ", diagnosis.motion().headline(), ".");
    MotionPage.add(page, log.drive(), diagnosis.motion());
    page.section("Files and program");
    List<Html> files = new ArrayList<>();
    files.add(Html.of("program ", provenance.version(), ", seed ", provenance.seed()));
    provenance
        .sha256()
        .forEach((file, hash) -> files.add(Html.of(file, ", SHA-256 ", Html.code(hash))));
    page.list(files);
    return page.html();
  }

  private void answer() {
    String names = String.join(", ", diagnosis.explanation());
    page.verdict(
        Html.strong(diagnosis.verdict().word()), names.isEmpty() ? "." : ": " + names + ".");
    for (Shared one : diagnosis.shared()) {
      page.say(one.words(), ".");
    }
    VerdictWords.addUnknown(
        page,
        diagnosis.verdict(),
        diagnosis.unknownProbability(),
        " is at work, in the readings or in the motion, is ");
    if (!diagnosis.isHeard()) {
      page.note("The readings are too few to say anything.");
    }
    if (diagnosis.motion().isSilent()) {
      page.note("The track is too short to say anything by itself.");
    }
  }

  /** What either half says of each value that both may show. */
  private void shared() {
    if (diagnosis.shared().isEmpty()) {
      page.say("No cause shows both to the tracker and to the sonar.");
      return;
    }
    page.section("One cause, one value");
    Table table =
        Table.of("cause", "heard as", "parameter", "#tracker", "#sonar", "#both together");
    for (Shared one : diagnosis.shared()) {
      table.row(
          one.name(),
          one.effect().word(),
          Html.code(one.parameter()),
          value(one.tracked()),
          value(one.heard()),
          one.isOne() ? value(one.together()) : "two causes");
    }
    page.table(table);
  }

  private static String value(Estimate estimate) {
    if (estimate.deviation() == Double.POSITIVE_INFINITY) {
      return "open";
    }
    // An interval may be narrow against its value.
    return String.format(
        Locale.ROOT,
        "%.5g (%.5g to %.5g)",
        estimate.value(),
        estimate.ci95().low(),
        estimate.ci95().high());
  }
}
