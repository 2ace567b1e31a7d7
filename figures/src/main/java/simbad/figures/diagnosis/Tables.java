package simbad.figures.diagnosis;

import java.util.List;
import simbad.figures.markup.Markup;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.FittedParameter;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.diagnosis.Undetectable;

/** The page's tables. */
final class Tables {
  private static final int MANY_PARAMETERS = 12;
  private static final int MOST_PLACES = 12;
  private static final int MOST_TRIED = 15;
  private static final double POSSIBLE = 0.05;

  private final StringBuilder page;

  Tables(StringBuilder page) {
    this.page = page;
  }

  void places(List<Place> places) {
    if (places.isEmpty()) {
      page.append(
          "<p>No slice of bearing, distance, angle, obstacle, sensor, run, time or speed has a gap"
              + " larger than elsewhere.</p>\n");
      return;
    }
    begin("place", "kind", "#rows", "#share of the gap", "#before, cm", "#after, cm", "#q");
    for (Place place : places.subList(0, Math.min(MOST_PLACES, places.size()))) {
      row(
          Places.words(place),
          place.kind().words(),
          "#" + place.rows(),
          "#" + Html.percent(place.shareOfGap()),
          "#" + Html.fixed(place.beforeCm(), 2),
          "#" + Html.fixed(place.afterCm(), 2),
          "#" + (place.qValue() < 1e-3 ? "&lt;&nbsp;0.001" : Html.fixed(place.qValue(), 3)));
    }
    end();
    page.append(
        "<p class=\"soft\">Found on one half of the data, confirmed and measured on the other; q is"
            + " the share of false finds among places with such a q or less. Places overlap.</p>\n");
  }

  /** Of what is concluded or at least possible. */
  void parameters(Diagnosis diagnosis) {
    List<EffectFinding> shown =
        diagnosis.effects().stream()
            .filter(finding -> !finding.parameters().isEmpty())
            .filter(
                finding ->
                    finding.probability() >= POSSIBLE
                        || diagnosis.explanation().contains(finding.effect()))
            .toList();
    if (shown.isEmpty()) {
      page.append("<p>No effect is probable enough for its parameters to mean something.</p>\n");
    }
    for (EffectFinding finding : shown) {
      boolean many = finding.parameters().size() > MANY_PARAMETERS;
      page.append(
          many
              ? "<details><summary>" + heading(finding) + "</summary>\n"
              : "<h3>" + heading(finding) + "</h3>\n");
      begin("parameter", "#fitted", "#95&nbsp;% interval");
      finding.parameters().forEach(this::parameter);
      end();
      page.append(many ? "</details>\n" : "");
    }
  }

  private static String heading(EffectFinding finding) {
    return finding.effect().word()
        + " ("
        + finding.form().map(form -> "form " + Markup.escaped(form) + ", ").orElse("")
        + "probability "
        + Html.probability(finding.probability())
        + ")";
  }

  private void parameter(FittedParameter parameter) {
    String unit = Places.unit(parameter.name());
    Interval ends = parameter.ci95();
    row(
        "<code>" + Markup.escaped(parameter.name()) + "</code>",
        "#" + Html.number(parameter.value()) + unit,
        "#" + interval(ends, unit));
  }

  static String interval(Interval ends, String unit) {
    return Double.isInfinite(ends.low()) && Double.isInfinite(ends.high())
        ? "not known from these data"
        : Html.number(ends.low()) + " to " + Html.number(ends.high()) + unit;
  }

  void undetectable(List<Undetectable> undetectable) {
    if (undetectable.isEmpty()) {
      page.append("<p>Every effect would have shown in these data.</p>\n");
      return;
    }
    begin("effect", "parameter", "#would have shown from");
    for (Undetectable one : undetectable) {
      row(
          one.effect().word(),
          "<code>" + Markup.escaped(one.parameter()) + "</code>",
          "#"
              + (one.leastSize().isPresent()
                  ? Html.number(one.leastSize().getAsDouble()) + Places.unit(one.parameter())
                  : "at no size"));
    }
    end();
  }

  void tried(List<Diagnosis.Attempt> tried) {
    begin("effects together", "#evidence, nats");
    for (Diagnosis.Attempt attempt : tried.subList(0, Math.min(MOST_TRIED, tried.size()))) {
      row(
          attempt.effects().isEmpty() ? "none (simulator as it is)" : Html.list(attempt.effects()),
          "#" + Html.fixed(attempt.heldOutNats(), 1));
    }
    end();
  }

  void begin(String... titles) {
    page.append("<div class=\"scroll\" tabindex=\"0\"><table><thead><tr>");
    for (String title : titles) {
      page.append(
          title.startsWith("#")
              ? "<th scope=\"col\" class=\"n\">" + title.substring(1) + "</th>"
              : "<th scope=\"col\">" + title + "</th>");
    }
    page.append("</tr></thead><tbody>\n");
  }

  /** Cells that begin with # are numbers. */
  void row(String... cells) {
    page.append("<tr>");
    for (String cell : cells) {
      page.append(
          cell.startsWith("#")
              ? "<td class=\"n\">" + cell.substring(1) + "</td>"
              : "<td>" + cell + "</td>");
    }
    page.append("</tr>\n");
  }

  void end() {
    page.append("</tbody></table></div>\n");
  }
}
