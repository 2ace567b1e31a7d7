package simbad.figures.diagnosis;

import java.util.List;
import simbad.experiments.motion.MotionFiles;
import simbad.figures.markup.Markup;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.Provenance;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.gap.motion.MotionPlace;

/** The page of a diagnosis of motion: what is at work, how far the gap shrinks, where it lies. */
public final class MotionPage {
  private static final String[] HORIZONS = {"0.5", "2", "5"};
  private static final int MOST_PLACES = 12;
  private static final double POSSIBLE = 0.05;
  private static final Shown MILLIMETRES = new Shown(1000, "&nbsp;mm");
  private static final Shown DEGREES = new Shown(Math.toDegrees(1), "°");
  private static final String LIMITS =
      "<p class=\"note\">Probabilities weigh sets of effects by how well they foretell stretches of"
          + " this log that were not fitted. Intervals hold for this log: another day differs by"
          + " more.</p>\n";

  private final StringBuilder page = new StringBuilder();
  private final Tables tables = new Tables(page);

  private MotionPage() {}

  /**
   * Returns the page as HTML.
   *
   * @param dataset its name
   * @param audit what was found of the data
   * @param diagnosis what was found
   * @param provenance what it was made by
   */
  public static String of(
      String dataset, List<AuditFinding> audit, MotionDiagnosis diagnosis, Provenance provenance) {
    MotionPage own = new MotionPage();
    String name = Markup.escaped(dataset);
    own.page.append(Style.head(name + ": " + diagnosis.verdict().word()));
    own.page.append("<h1>How the robot moves: " + name + "</h1>\n<p class=\"verdict\"><strong>");
    own.page.append(diagnosis.verdict().word() + "</strong>: ");
    own.page.append(Markup.escaped(diagnosis.headline()) + ".</p>\n" + LIMITS);
    AuditSection.add(own.page, audit, dataset);
    own.effects(diagnosis);
    own.gap(diagnosis.gap());
    own.budget(diagnosis.budget());
    own.places(diagnosis.places());
    own.hidden(diagnosis.undetectable());
    own.page.append("<h2>What this was made of</h2>\n<p class=\"soft\">Program ");
    own.page.append(Markup.escaped(provenance.version()) + ", ");
    own.page.append(diagnosis.gap().windows() + " windows of half a second.</p>\n");
    return own.page.append("</main>\n</body>\n</html>\n").toString();
  }

  private void effects(MotionDiagnosis diagnosis) {
    page.append("<h2>What is at work</h2>\n");
    if (diagnosis.findings().isEmpty()) {
      page.append("<p>No effect is named.</p>\n");
    }
    diagnosis.findings().forEach(this::effect);
    page.append("<p>Something without a name: ");
    page.append(Html.probability(diagnosis.unknownProbability()) + ".");
    for (MotionFinding other : diagnosis.others()) {
      if (other.probability() >= POSSIBLE) {
        page.append(" Perhaps " + Markup.escaped(other.effect()) + ": ");
        page.append(Html.probability(other.probability()) + ".");
      }
    }
    page.append("</p>\n");
    diagnosis.next().ifPresent(this::next);
  }

  private void next(MotionDiagnosis.NextDrive next) {
    page.append("<p>The drive of <code>" + MotionFiles.NEXT + "</code> would tell ");
    page.append(Markup.escaped(String.join(" from ", next.separates())) + " (expected log odds ");
    page.append(Html.fixed(next.expectedLogOdds(), 1) + ").</p>\n");
  }

  private void effect(MotionFinding finding) {
    page.append("<h3>" + Markup.escaped(finding.form()) + " (");
    page.append(Html.probability(finding.probability()) + ")</h3>\n");
    tables.begin("parameter", "#fitted", "#95&nbsp;% interval");
    for (MotionFinding.Parameter parameter : finding.parameters()) {
      String unit = Places.unit(parameter.name());
      tables.row(
          "<code>" + Markup.escaped(parameter.name()) + "</code>",
          "#" + Html.number(parameter.value()) + unit + (parameter.atBound() ? " (bound)" : ""),
          "#" + Tables.interval(parameter.ci95(), unit));
    }
    tables.end();
    page.append("<p>What to do: " + Markup.escaped(finding.remedy()) + ".");
    if (!finding.ties().isEmpty()) {
      page.append(" This log does not tell it from ");
      page.append(Markup.escaped(String.join(", ", finding.ties())) + ".");
    }
    page.append("</p>\n");
  }

  private void gap(MotionDiagnosis.Gap diagnosis) {
    page.append("<h2>How well the models forecast</h2>\n<p>Continuous ranked probability score of");
    page.append(
        " forecasts, on stretches of the log that were not fitted. Over all it shrinks by ");
    page.append(Html.percent(diagnosis.shrink()) + " (95&nbsp;% interval ");
    page.append(Html.percent(diagnosis.shrinkCi95().low()) + " to ");
    page.append(Html.percent(diagnosis.shrinkCi95().high()) + ").</p>\n");
    tables.begin("forecast over", "component", "#before", "#after", "#seen within 90&nbsp;%");
    for (int h = 0; h < HORIZONS.length; h++) {
      row(diagnosis, h, 0, "along", MILLIMETRES);
      row(diagnosis, h, 1, "across", MILLIMETRES);
      row(diagnosis, h, 2, "turn", DEGREES);
    }
    tables.end();
  }

  private void row(
      MotionDiagnosis.Gap diagnosis, int horizon, int component, String name, Shown shown) {
    double before = shown.times * diagnosis.before()[horizon][component];
    double after = shown.times * diagnosis.after()[horizon][component];
    tables.row(
        HORIZONS[horizon] + "&nbsp;s",
        name,
        "#" + Html.fixed(before, 2) + shown.unit,
        "#" + Html.fixed(after, 2) + shown.unit,
        "#" + Html.percent(diagnosis.coverage()[horizon][component]));
  }

  private void budget(List<MotionDiagnosis.Part> budget) {
    page.append("<h2>What the gap is made of</h2>\n");
    tables.begin("part", "#share of the gap before", "#95&nbsp;% interval");
    for (MotionDiagnosis.Part part : budget) {
      tables.row(
          Markup.escaped(part.what()),
          "#" + Html.percent(part.share()),
          "#" + Html.percent(part.ci95().low()) + " to " + Html.percent(part.ci95().high()));
    }
    tables.end();
  }

  private void hidden(List<MotionDiagnosis.Hidden> hidden) {
    if (hidden.isEmpty()) {
      return;
    }
    page.append("<h2>What this log could not have shown</h2>\n");
    tables.begin("effect", "parameter", "#least size that would have shown");
    for (MotionDiagnosis.Hidden one : hidden) {
      tables.row(
          Markup.escaped(one.effect()),
          "<code>" + Markup.escaped(one.parameter()) + "</code>",
          "#" + (Double.isFinite(one.leastSize()) ? Html.number(one.leastSize()) : "none"));
    }
    tables.end();
  }

  private record Shown(double times, String unit) {}

  private void places(List<MotionPlace> places) {
    page.append("<h2>Where the gap lies</h2>\n<p>Scores of forecasts over half a second,");
    page.append(
        " each component in units of its mean before; q is the share of false finds.</p>\n");
    tables.begin(
        "slice", "#from", "#to", "#windows", "#share of the gap", "#before", "#after", "#q");
    for (MotionPlace place : places.subList(0, Math.min(MOST_PLACES, places.size()))) {
      tables.row(
          "<code>" + place.axis() + "</code> " + Markup.escaped(place.name()),
          "#" + end(place.axis(), place.low()),
          "#" + end(place.axis(), place.high()),
          "#" + place.rows(),
          "#" + Html.percent(place.share()),
          "#" + Html.fixed(place.before(), 2),
          "#" + Html.fixed(place.after(), 2),
          "#" + (place.qValue() < 1e-3 ? "&lt;&nbsp;0.001" : Html.fixed(place.qValue(), 3)));
    }
    tables.end();
  }

  /** Clocks that count from 1970 need all their digits. */
  private static String end(String axis, double value) {
    return axis.equals("t_s") ? Html.fixed(value, 0) : Html.number(value);
  }
}
