package simbad.experiments.diagnosis;

import java.util.List;
import simbad.experiments.markup.Markup;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.GapFigures;
import simbad.gap.diagnosis.Place;

/** What a reader knows who reads no further: verdict, probabilities, shrinkage, the worst place. */
final class FirstScreen {
  private static final int LEAST_BARS = 3;
  private static final int MOST_BARS = 6;
  private static final double WORTH_A_BAR = 0.02;

  private final Diagnosis diagnosis;
  private final StringBuilder page;

  private FirstScreen(Diagnosis diagnosis, StringBuilder page) {
    this.diagnosis = diagnosis;
    this.page = page;
  }

  static void add(StringBuilder page, Diagnosis diagnosis, String dataset) {
    FirstScreen screen = new FirstScreen(diagnosis, page);
    page.append("<h1>Simulation and reality: " + Markup.escaped(dataset) + "</h1>\n");
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
    page.append("</section>\n");
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
