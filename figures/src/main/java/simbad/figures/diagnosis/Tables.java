package simbad.figures.diagnosis;

import java.util.List;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Page;
import simbad.figures.page.Table;
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

  private final Page page;

  Tables(Page page) {
    this.page = page;
  }

  void places(List<Place> places) {
    if (places.isEmpty()) {
      page.say(
          "The gap is not larger in any slice of bearing, distance, angle, obstacle, "
              + "sensor, run, time or speed than elsewhere.");
      return;
    }
    Table table =
        Table.of("place", "kind", "#rows", "#share of the gap", "#before, cm", "#after, cm", "#q");
    for (Place place : places.subList(0, Math.min(MOST_PLACES, places.size()))) {
      table.row(
          PlaceWords.words(place),
          place.kind().words(),
          place.rows(),
          Numbers.percent(place.shareOfGap()),
          Numbers.fixed(place.beforeCm(), 2),
          Numbers.fixed(place.afterCm(), 2),
          Numbers.qValue(place.qValue()));
    }
    page.table(table);
    page.soft(
        "Each place was found on one half of the data, then confirmed and measured on "
            + "the other half. q is the expected share of false finds among all places with "
            + "this q or a smaller one. Places overlap.");
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
      page.say("No effect is probable enough for its values to mean something.");
    }
    shown.forEach(this::parameters);
  }

  private void parameters(EffectFinding finding) {
    Table table = Table.of("parameter", "#fitted", "#95\u00a0% interval");
    finding.parameters().forEach(parameter -> add(table, parameter));
    if (finding.parameters().size() > MANY_PARAMETERS) {
      page.add(Page.folded(heading(finding), table.html()));
    } else {
      page.part(heading(finding)).table(table);
    }
  }

  private static String heading(EffectFinding finding) {
    return finding.effect().word()
        + " ("
        + finding.form().map(form -> "form " + form + ", ").orElse("")
        + "probability "
        + Numbers.probability(finding.probability())
        + ")";
  }

  private static void add(Table table, FittedParameter parameter) {
    String unit = PlaceWords.unit(parameter.name());
    table.row(
        Html.code(parameter.name()),
        value(parameter.value(), parameter.ci95()) + unit,
        interval(parameter.ci95(), unit));
  }

  static String value(double value, Interval ci95) {
    return Numbers.number(value, ci95.low(), ci95.high());
  }

  static String interval(Interval ends, String unit) {
    return Double.isInfinite(ends.low()) && Double.isInfinite(ends.high())
        ? "not known from these data"
        : value(ends.low(), ends) + " to " + value(ends.high(), ends) + unit;
  }

  void undetectable(List<Undetectable> undetectable) {
    if (undetectable.isEmpty()) {
      page.say("Every effect would have shown in these data.");
      return;
    }
    Table table = Table.of("effect", "parameter", "#would have shown from this size on");
    for (Undetectable one : undetectable) {
      table.row(
          one.effect().word(),
          Html.code(one.parameter()),
          one.leastSize().isPresent()
              ? Numbers.number(one.leastSize().getAsDouble()) + PlaceWords.unit(one.parameter())
              : "at no size");
    }
    page.table(table);
  }

  void tried(List<Diagnosis.Attempt> tried) {
    Table table = Table.of("effects together", "#evidence, nats");
    for (Diagnosis.Attempt attempt : tried.subList(0, Math.min(MOST_TRIED, tried.size()))) {
      table.row(
          attempt.effects().isEmpty() ? "none (simulator as it is)" : Names.list(attempt.effects()),
          Numbers.fixed(attempt.heldOutNats(), 1));
    }
    page.table(table);
  }
}
