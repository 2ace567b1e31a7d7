package simbad.figures.diagnosis;

import java.util.List;
import simbad.figures.markup.Markup;
import simbad.gap.diagnosis.BudgetEntry;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.GapFigures;
import simbad.gap.diagnosis.Place;
import simbad.gap.diagnosis.Remedies;
import simbad.sonar.scene.SonarSpec;

/** What a reader knows who reads no further: verdict, probabilities, shrinkage, the worst place. */
final class FirstScreen {
  private static final int LEAST_BARS = 3;
  private static final int MOST_BARS = 6;
  private static final double WORTH_A_BAR = 0.02;

  private final Diagnosis diagnosis;
  private final SonarSpec sensor;
  private final StringBuilder page;

  private FirstScreen(Diagnosis diagnosis, SonarSpec sensor, StringBuilder page) {
    this.diagnosis = diagnosis;
    this.sensor = sensor;
    this.page = page;
  }

  static void add(StringBuilder page, Diagnosis diagnosis, DataSet data) {
    FirstScreen screen = new FirstScreen(diagnosis, data.setup().sensor(), page);
    page.append("<p class=\"verdict\">" + VerdictWords.sentence(diagnosis) + "</p>\n");
    page.append(VerdictWords.second(diagnosis));
    page.append("<div class=\"panels\">\n");
    screen.probabilities();
    screen.shrinkage();
    page.append("</div>\n");
    screen.worstPlace();
  }

  private void probabilities() {
    page.append("<section class=\"panel\"><h3>Which effect is at work: probability</h3>\n");
    page.append("<div class=\"bars\">\n");
    List<EffectFinding> effects = diagnosis.effects();
    for (int i = 0; i < Math.min(MOST_BARS, effects.size()); i++) {
      EffectFinding finding = effects.get(i);
      if (i < LEAST_BARS || finding.probability() >= WORTH_A_BAR) {
        probability(finding.effect().word(), finding.probability(), "after");
      }
    }
    probability("something else", diagnosis.unknownProbability(), "unknown");
    page.append("</div>\n");
    for (EffectFinding finding : VerdictWords.named(diagnosis)) {
      page.append(
          "<p class=\"soft\">"
              + finding.effect().word()
              + ": "
              + VerdictWords.meaning(finding.effect())
              + ". <strong>What to do:</strong> "
              + Markup.escaped(Remedies.of(finding, sensor))
              + ".</p>\n");
    }
    page.append("</section>\n");
  }

  private void probability(String name, double probability, String style) {
    bar(name, fill(probability, style), Html.probability(probability));
  }

  private void shrinkage() {
    GapFigures gap = diagnosis.gap();
    double most = Math.max(gap.beforeCm(), Math.max(gap.afterCm(), gap.floorCm()));
    AxisScale scale = AxisScale.over(0, most, 4);
    page.append("<section class=\"panel\"><h3>How far the gap shrinks: mean gap in cm</h3>\n");
    page.append("<div class=\"bars\">\n");
    size("before", gap.beforeCm(), scale, "before", "");
    boolean shrinks = !diagnosis.explanation().isEmpty();
    size("after", gap.afterCm(), scale, "after", shrinks ? whisker(gap, scale) : "");
    size("floor", gap.floorCm(), scale, "floor", "");
    page.append("</div>\n");
    page.append("<p class=\"soft\">" + shrinks(gap) + "</p>\n");
    budget();
    page.append("</section>\n");
  }

  /** One bar, as long as the gap before: each effect's share, the rest, the floor. */
  private void budget() {
    double all = diagnosis.budget().stream().mapToDouble(entry -> Math.max(0, entry.cm())).sum();
    if (!(all > 0)) {
      return;
    }
    page.append("<h3>What the gap before is made of, in cm</h3>\n<div class=\"budget\">\n");
    int effect = 0;
    for (BudgetEntry entry : diagnosis.budget()) {
      String style = budgetStyle(entry, effect++);
      page.append(
          "<span class=\"fill "
              + style
              + "\" style=\"flex-grow:"
              + Svg.number(Math.max(0, entry.cm()) / all)
              + "\" title=\""
              + words(entry)
              + "\"></span>\n");
    }
    page.append("</div>\n<p class=\"soft\">");
    effect = 0;
    for (BudgetEntry entry : diagnosis.budget()) {
      page.append(
          "<span class=\"key "
              + budgetStyle(entry, effect++)
              + "\"></span>&nbsp;"
              + words(entry)
              + "; ");
    }
    page.append("with 95&nbsp;% intervals. The parts add up to the gap before.</p>\n");
  }

  private static String budgetStyle(BudgetEntry entry, int effect) {
    return switch (entry.what()) {
      case BudgetEntry.REST -> "unknown";
      case BudgetEntry.FLOOR -> "floor";
      default -> "effect" + Math.min(2, effect);
    };
  }

  private static String words(BudgetEntry entry) {
    String name =
        switch (entry.what()) {
          case BudgetEntry.REST -> "not explained";
          case BudgetEntry.FLOOR -> "scatter (floor)";
          default -> entry.what();
        };
    return name
        + " "
        + Html.fixed(entry.cm(), 2)
        + " ("
        + Html.fixed(entry.ci95().low(), 2)
        + " to "
        + Html.fixed(entry.ci95().high(), 2)
        + ")";
  }

  private String shrinks(GapFigures gap) {
    if (diagnosis.explanation().isEmpty()) {
      return "No effect was put into the simulator, so the gap after is the gap before. The floor is"
          + " the scatter that the simulator itself expects.";
    }
    return "The gap shrinks by "
        + Html.percent(gap.shrink())
        + " (95&nbsp;% interval "
        + Html.percent(gap.shrinkCi95().low())
        + " to "
        + Html.percent(gap.shrinkCi95().high())
        + ", the line on the bar), measured on "
        + gap.rowsHeldOut()
        + " rows that the fit never saw. The floor is the scatter that the diagnosed model expects.";
  }

  private void size(String name, double cm, AxisScale scale, String style, String more) {
    bar(name, fill(scale.share(cm), style) + more, Html.fixed(cm, 2));
  }

  /** The interval of the shrinkage as one of the gap after it, for the gap before it is fixed. */
  private static String whisker(GapFigures gap, AxisScale scale) {
    double low = clamp(scale.share(gap.beforeCm() * (1 - gap.shrinkCi95().high())));
    double high = clamp(scale.share(gap.beforeCm() * (1 - gap.shrinkCi95().low())));
    return "<span class=\"whisker\" style=\"left:"
        + Svg.number(100 * low)
        + "%;width:"
        + Svg.number(100 * (high - low))
        + "%\"></span>";
  }

  private static double clamp(double share) {
    return Math.max(0, Math.min(1, share));
  }

  private static String fill(double share, String style) {
    return "<span class=\"fill "
        + style
        + "\" style=\"width:"
        + Svg.number(100 * clamp(share))
        + "%\"></span>";
  }

  private void bar(String name, String inTrack, String value) {
    page.append(
        "<span>"
            + name
            + "</span><span class=\"track\">"
            + inTrack
            + "</span><span class=\"value\">"
            + value
            + "</span>\n");
  }

  private void worstPlace() {
    if (diagnosis.where().isEmpty()) {
      return;
    }
    Place place = diagnosis.where().get(0);
    page.append(
        "<p><strong>Where most of it lies:</strong> "
            + Places.words(place)
            + ": "
            + place.kind().words()
            + ", "
            + Html.percent(place.shareOfGap())
            + " of the gap, "
            + Html.centimetres(place.beforeCm())
            + " before and "
            + Html.centimetres(place.afterCm())
            + " after.</p>\n");
  }
}
