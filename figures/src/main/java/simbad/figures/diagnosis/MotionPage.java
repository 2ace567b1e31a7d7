package simbad.figures.diagnosis;

import java.util.List;
import simbad.figures.markup.Markup;
import simbad.gap.diagnosis.Provenance;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.gap.motion.MotionPlace;

/** The page of a diagnosis of motion: what is at work, how far the gap shrinks, where it lies. */
public final class MotionPage {
  private static final String[] HORIZONS = {"0.5", "2", "5"};
  private static final int MOST_PLACES = 12;
  private static final Shown MILLIMETRES = new Shown(1000, "&nbsp;mm");
  private static final Shown DEGREES = new Shown(Math.toDegrees(1), "°");
  private static final String LIMITS =
      "<p class=\"note\">A first version: a name is a candidate. <i>Needed</i> is how sure it is that"
          + " forecasts are better with it than without, not that no other name would do. Another day's log of the same robot"
          + " is the test of it; intervals hold for this log.</p>\n";

  private final StringBuilder page = new StringBuilder();
  private final Tables tables = new Tables(page);

  private MotionPage() {}

  /**
   * Returns the page as HTML.
   *
   * @param dataset its name
   * @param diagnosis what was found
   * @param provenance what it was made by
   */
  public static String of(String dataset, MotionDiagnosis diagnosis, Provenance provenance) {
    MotionPage own = new MotionPage();
    String name = Markup.escaped(dataset);
    own.page.append(Style.head(name + ": " + diagnosis.verdict().word()));
    own.page.append("<h1>How the robot moves: " + name + "</h1>\n<p class=\"verdict\"><strong>");
    own.page.append(diagnosis.verdict().word() + "</strong>: ");
    own.page.append(Markup.escaped(diagnosis.headline()) + ".</p>\n" + LIMITS);
    own.effects(diagnosis.findings());
    own.gap(diagnosis);
    own.places(diagnosis.places());
    own.page.append("<h2>What this was made of</h2>\n<p class=\"soft\">Program ");
    own.page.append(Markup.escaped(provenance.version()) + ", ");
    own.page.append(diagnosis.windows() + " windows of half a second.</p>\n");
    return own.page.append("</main>\n</body>\n</html>\n").toString();
  }

  private void effects(List<MotionFinding> findings) {
    page.append("<h2>What is at work</h2>\n");
    if (findings.isEmpty()) {
      page.append("<p>No effect is named.</p>\n");
    }
    for (MotionFinding finding : findings) {
      page.append("<h3>" + Markup.escaped(finding.form()) + " (needed: ");
      page.append(Html.probability(finding.probability()) + ")</h3>\n");
      tables.begin("parameter", "#fitted", "#95&nbsp;% interval");
      for (MotionFinding.Parameter parameter : finding.parameters()) {
        String unit = Places.unit(parameter.name());
        tables.row(
            "<code>" + Markup.escaped(parameter.name()) + "</code>",
            "#" + Html.number(parameter.value()) + unit,
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
  }

  private void gap(MotionDiagnosis diagnosis) {
    page.append("<h2>How well the models forecast</h2>\n<p>Continuous ranked probability score of");
    page.append(
        " forecasts, on stretches of the log that were not fitted. Over all it shrinks by ");
    page.append(Html.percent(diagnosis.shrink()) + " (95&nbsp;% interval ");
    page.append(Html.percent(diagnosis.shrinkCi95().low()) + " to ");
    page.append(Html.percent(diagnosis.shrinkCi95().high()) + ").</p>\n");
    tables.begin("forecast over", "component", "#before", "#after");
    for (int h = 0; h < HORIZONS.length; h++) {
      row(diagnosis, h, 0, "along", MILLIMETRES);
      row(diagnosis, h, 1, "across", MILLIMETRES);
      row(diagnosis, h, 2, "turn", DEGREES);
    }
    tables.end();
  }

  private void row(
      MotionDiagnosis diagnosis, int horizon, int component, String name, Shown shown) {
    double before = shown.times * diagnosis.before()[horizon][component];
    double after = shown.times * diagnosis.after()[horizon][component];
    tables.row(
        HORIZONS[horizon] + "&nbsp;s",
        name,
        "#" + Html.fixed(before, 2) + shown.unit,
        "#" + Html.fixed(after, 2) + shown.unit);
  }

  private record Shown(double times, String unit) {}

  private void places(List<MotionPlace> places) {
    page.append("<h2>Where the gap lies</h2>\n<p>Mean absolute errors over half a second, each");
    page.append(" component in units of its mean before.</p>\n");
    tables.begin("slice", "#from", "#to", "#windows", "#share of the gap", "#before", "#after");
    for (MotionPlace place : places.subList(0, Math.min(MOST_PLACES, places.size()))) {
      tables.row(
          "<code>" + place.axis() + "</code>",
          "#" + Html.number(place.low()),
          "#" + Html.number(place.high()),
          "#" + place.rows(),
          "#" + Html.percent(place.share()),
          "#" + Html.fixed(place.before(), 2),
          "#" + Html.fixed(place.after(), 2));
    }
    tables.end();
  }
}
