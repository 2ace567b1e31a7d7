package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import simbad.experiments.motion.MotionFiles;
import simbad.figures.page.Bars;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Page;
import simbad.figures.page.PagePicture;
import simbad.figures.page.Table;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.gap.motion.MotionPlace;
import simbad.motion.format.MotionData;

/** The page of a diagnosis of motion: what is at work, how far the gap shrinks, where it lies. */
public final class MotionPage {
  /** Seconds over which is forecast. */
  static final String[] HORIZONS = {"0.5", "2", "5"};

  private static final String[] COMPONENTS = {"along", "across", "turn"};
  private static final int TURN = 2;
  private static final int MOST_PLACES = 12;
  private static final double POSSIBLE = 0.05;
  private static final Shown MILLIMETRES = new Shown(1000, "\u00a0mm");
  private static final Shown DEGREES = new Shown(Math.toDegrees(1), "°");
  private static final String LIMITS =
      "Probabilities say how often such an answer was right in simulated drives whose truth "
          + "was known afterwards. Intervals of values hold for this log; another day can differ "
          + "by more.";

  private final Page page;

  private MotionPage(Page page) {
    this.page = page;
  }

  /**
   * Returns the page as HTML.
   *
   * @param data what was diagnosed
   * @param audit what was found of the data
   * @param diagnosis what was found
   * @param provenance what it was made by
   */
  public static String of(
      MotionData data,
      List<AuditFinding> audit,
      MotionDiagnosis diagnosis,
      DiagnosisProvenance provenance) {
    String dataset = data.name();
    String verdict = diagnosis.verdict().word();
    Page page = new Page(dataset + ": " + verdict, "How the robot moves: " + dataset);
    page.verdict(Html.strong(verdict), ": ", diagnosis.headline(), ".").note(LIMITS);
    AuditSection.add(page, audit, dataset);
    add(page, data, diagnosis);
    new MotionPage(page).origin(diagnosis, provenance);
    return page.html();
  }

  /** Adds all but the verdict, the audit and what it was made of. */
  static void add(Page page, MotionData data, MotionDiagnosis diagnosis) {
    MotionPage own = new MotionPage(page);
    own.effects(diagnosis);
    own.gap(data, diagnosis);
    own.budget(diagnosis.budget());
    own.places(diagnosis.places());
    own.hidden(diagnosis.undetectable());
  }

  private void origin(MotionDiagnosis diagnosis, DiagnosisProvenance provenance) {
    page.section("Files and program");
    page.soft(
        "Program ",
        provenance.version(),
        ", ",
        diagnosis.gap().windows(),
        " windows of half a second.");
  }

  private void effects(MotionDiagnosis diagnosis) {
    page.section("Effects at work");
    page.add(Page.panel("", "Probability", probabilities(diagnosis)));
    if (diagnosis.findings().isEmpty()) {
      page.say("No effect is named.");
    }
    diagnosis.findings().forEach(this::effect);
    List<Object> rest = new ArrayList<>();
    if (diagnosis.verdict() != Verdict.UNDECIDED) {
      rest.add("The verdict is right: ");
      rest.add(Numbers.probability(diagnosis.probability(diagnosis.verdict())) + ". ");
    }
    rest.add("Something unknown: ");
    rest.add(Numbers.probability(diagnosis.unknownProbability()) + ".");
    for (MotionFinding other : possible(diagnosis)) {
      rest.add(" Perhaps " + other.effect() + ": ");
      rest.add(Numbers.probability(other.probability()) + ".");
    }
    page.say(rest.toArray());
    diagnosis.next().ifPresent(this::next);
  }

  private static List<MotionFinding> possible(MotionDiagnosis diagnosis) {
    return diagnosis.others().stream().filter(other -> other.probability() >= POSSIBLE).toList();
  }

  private static Html probabilities(MotionDiagnosis diagnosis) {
    Bars bars = new Bars();
    diagnosis.findings().forEach(one -> bar(bars, one.form(), one.probability(), "after"));
    possible(diagnosis).forEach(one -> bar(bars, one.effect(), one.probability(), "after"));
    bar(bars, "unknown", diagnosis.unknownProbability(), "unknown");
    return bars.html();
  }

  private static void bar(Bars bars, String name, double probability, String style) {
    bars.bar(name, probability, style, Numbers.probability(probability));
  }

  private void next(MotionDiagnosis.NextDrive next) {
    page.say(
        "Driving the commands of ",
        Html.code(MotionFiles.NEXT),
        " would tell ",
        String.join(" from ", next.separates()),
        " (expected log odds ",
        Numbers.fixed(next.expectedLogOdds(), 1),
        ").");
  }

  private void effect(MotionFinding finding) {
    page.part(finding.form() + " (" + Numbers.probability(finding.probability()) + ")");
    Table table = Table.of("parameter", "#fitted", "#95\u00a0% interval");
    for (MotionFinding.Parameter parameter : finding.parameters()) {
      String unit = PlaceWords.unit(parameter.name());
      table.row(
          Html.code(parameter.name()),
          Tables.value(parameter.value(), parameter.ci95())
              + unit
              + (parameter.atBound() ? " (bound)" : ""),
          Tables.interval(parameter.ci95(), unit));
    }
    page.table(table);
    page.say(
        "What to do: ",
        finding.remedy(),
        ".",
        finding.ties().isEmpty()
            ? ""
            : " This log cannot tell it from " + String.join(", ", finding.ties()) + ".");
  }

  private static String range(Interval shares) {
    return Numbers.percent(shares.low()) + " to " + Numbers.percent(shares.high());
  }

  private void gap(MotionData data, MotionDiagnosis diagnosis) {
    MotionDiagnosis.Gap gap = diagnosis.gap();
    page.section("How well the models forecast");
    page.say(
        "Continuous ranked probability score of forecasts, on stretches of the log "
            + "that were not used for the fit. In total it shrinks by ",
        Numbers.percent(gap.shrink()),
        " (95\u00a0% interval ",
        range(gap.shrinkHere95()),
        "). On another drive of this robot it would shrink by ",
        range(gap.shrinkCi95()),
        ", 19 times of 20: other commands bring out other causes.");
    Table table =
        Table.of("forecast over", "component", "#before", "#after", "#seen within 90\u00a0%");
    for (int h = 0; h < HORIZONS.length; h++) {
      for (int c = 0; c < COMPONENTS.length; c++) {
        Shown shown = c == TURN ? DEGREES : MILLIMETRES;
        table.row(
            HORIZONS[h] + "\u00a0s",
            COMPONENTS[c],
            shown.words(gap.before()[h][c]),
            shown.words(gap.after()[h][c]),
            Numbers.percent(gap.coverage()[h][c]));
      }
    }
    page.table(table);
    List<PagePicture> pictures = pictures(gap);
    TrackPlan.of(data.runs(), data.robot().motion(), diagnosis.forecast().chain())
        .ifPresent(pictures::add);
    page.pictures(pictures);
  }

  private static List<PagePicture> pictures(MotionDiagnosis.Gap gap) {
    List<PagePicture> pictures = new ArrayList<>();
    for (int c = 0; c < COMPONENTS.length; c++) {
      Shown shown = c == TURN ? DEGREES : MILLIMETRES;
      pictures.add(
          new PagePicture(
              COMPONENTS[c],
              HorizonGraph.of(COMPONENTS[c], shown, gap, c),
              Html.of(Html.key("before"), " before, ", Html.key("after"), " after"),
              Html.NONE));
    }
    return pictures;
  }

  private void budget(List<MotionDiagnosis.Part> budget) {
    page.section("Parts of the gap before");
    Table table = Table.of("part", "#share of the gap before", "#95\u00a0% interval");
    for (MotionDiagnosis.Part part : budget) {
      table.row(
          Names.part(part.what()),
          Numbers.percent(part.share()),
          Numbers.percent(part.ci95().low()) + " to " + Numbers.percent(part.ci95().high()));
    }
    page.table(table);
  }

  private void hidden(List<MotionDiagnosis.Hidden> hidden) {
    if (hidden.isEmpty()) {
      return;
    }
    page.section("Effects that this log could not show");
    Table table = Table.of("effect", "parameter", "#smallest size that would have shown");
    for (MotionDiagnosis.Hidden one : hidden) {
      table.row(
          one.effect(),
          Html.code(one.parameter()),
          Double.isFinite(one.leastSize()) ? Numbers.number(one.leastSize()) : "none");
    }
    page.table(table);
  }

  /**
   * How a component is shown.
   *
   * @param times what its values are multiplied with
   * @param unit behind them
   */
  record Shown(double times, String unit) {
    String words(double value) {
      return Numbers.fixed(times * value, 2) + unit;
    }
  }

  private void places(List<MotionPlace> places) {
    page.section("Where the gap lies");
    page.say(
        "Scores of forecasts over half a second. Each component is in units of its "
            + "mean before. q is the expected share of false finds.");
    Table table =
        Table.of("place", "kind", "#windows", "#share of the gap", "#before", "#after", "#q");
    for (MotionPlace place : places.subList(0, Math.min(MOST_PLACES, places.size()))) {
      table.row(
          PlaceWords.words(place),
          place.component(),
          place.rows(),
          Numbers.percent(place.share()),
          Numbers.fixed(place.before(), 2),
          Numbers.fixed(place.after(), 2),
          Numbers.qValue(place.qValue()));
    }
    page.table(table);
  }
}
