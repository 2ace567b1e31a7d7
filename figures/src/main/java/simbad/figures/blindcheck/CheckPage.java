package simbad.figures.blindcheck;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simbad.experiments.blindcheck.CheckOrder;
import simbad.experiments.blindcheck.CheckScores;
import simbad.experiments.blindcheck.CheckScores.Estimate;
import simbad.experiments.blindcheck.CheckScores.Figures;
import simbad.experiments.blindcheck.Measure;
import simbad.experiments.blindcheck.SizeFound;
import simbad.experiments.blindcheck.ToldApart;
import simbad.figures.page.Html;
import simbad.figures.page.Page;
import simbad.figures.page.PagePicture;
import simbad.figures.page.Table;

/** The page of a check: one file, its first screen is the scoring table. */
final class CheckPage {
  private static final Object[] LEVELS = {
    "Levels of independence: L0 the checker shares code with what it checks; ",
    Html.strong("L1"),
    " independent code, the same equations; ",
    Html.strong("L2"),
    " besides, other physics in the set-up; ",
    Html.strong("L2w"),
    " echoes with a wave form and a receiver, and a user who calibrates; L3 a "
        + "physical log. L1 finds faults of the program. Only L2 and L3 show how well "
        + "the diagnosis does elsewhere; where L1 and L2 differ, believe L2. For robots "
        + "that drive the levels are ",
    Html.strong("M1"),
    ", independent code and a robot as it is believed to be, and ",
    Html.strong("M2"),
    ", a robot that is a little off by itself."
  };

  /** All of them are in the check's table of cases. */
  private static final int MOST_WRONG = 200;

  private static final String NOTHING = "\u2013";

  private final Page page = new Page("The withheld check", "The withheld check of simbad diagnose");
  private final CheckOrder order;
  private final CheckScores scores;
  private final List<ToldApart> next;

  private CheckPage(CheckOrder order, CheckScores scores, List<ToldApart> next) {
    this.order = order;
    this.scores = scores;
    this.next = next;
  }

  static String of(CheckOrder order, CheckScores scores, List<ToldApart> next) {
    return new CheckPage(order, scores, next).text();
  }

  private String text() {
    addHeadline();
    scores.parts().forEach(part -> addScores(part, Measure.ALL.subList(0, Measure.FIRST)));
    page.soft(LEVELS);
    addCalibration();
    addKinds();
    addWrong();
    addNext();
    addEffects();
    addSizes();
    addConfusion();
    page.section("Further scores");
    scores
        .parts()
        .forEach(part -> addScores(part, Measure.ALL.subList(Measure.FIRST, Measure.ALL.size())));
    addOrigin();
    return page.html();
  }

  private Optional<Figures> diagnosis(String part) {
    return scores.figures(part, CheckScores.DIAGNOSIS);
  }

  private void addHeadline() {
    String part = scores.parts().get(0);
    diagnosis(part)
        .flatMap(figures -> figures.share("all verdicts right"))
        .ifPresent(right -> addHeadline(part, right));
    if (!order.withheld().isEmpty()) {
      page.note(
          "The diagnosis did not know ",
          String.join(", ", order.withheld()),
          ": it must call such data unexplained.");
    }
    long unanswered = scores.cases().stream().filter(one -> !one.has("verdict")).count();
    if (unanswered > 0) {
      page.note(
          unanswered == 1
              ? "1 case has no answer. It counts as wrong everywhere."
              : unanswered + " cases have no answer. They count as wrong everywhere.");
    }
  }

  private void addHeadline(String part, Estimate right) {
    page.verdict(
        "The truth of each data set was sealed before the diagnosis. Data sets with "
            + "the right verdict: ",
        Html.strong(right.counted()),
        ", ",
        Measure.percent(right.value()),
        " (95\u00a0% interval ",
        Measure.percent(right.low()),
        " to ",
        Measure.percent(right.high()),
        "). Independence: ",
        part,
        ".");
  }

  private void addScores(String part, List<Measure> measures) {
    int cases = diagnosis(part).map(Figures::cases).orElse(0);
    Table table =
        Table.of(
                "score",
                "diagnosis, 95\u00a0% interval",
                "counted",
                "#to reach",
                "#baseline",
                "#oracle")
            .styled("scores")
            .withRowHeads();
    measures.forEach(measure -> addScore(table, part, measure));
    page.part(part + ", " + cases + " cases").table(table);
  }

  private void addScore(Table table, String part, Measure measure) {
    diagnosis(part)
        .flatMap(measure.of())
        .ifPresent(
            found ->
                table.row(
                    measure.words(),
                    ScoreCell.value(measure, found, isOff(part)),
                    Html.soft(found.counted()),
                    ScoreCell.reached(measure, found, isOff(part)),
                    of(part, CheckScores.SORTS.get(1), measure),
                    of(part, CheckScores.SORTS.get(2), measure)));
  }

  private String of(String part, String sort, Measure measure) {
    return scores
        .figures(part, sort)
        .flatMap(measure.of())
        .map(estimate -> measure.text(estimate.value()))
        .orElse(NOTHING);
  }

  /** Whether all of a part's cases have a set-up that is itself a little off. */
  private static boolean isOff(String part) {
    return (part.contains("L2") && !part.contains("L1"))
        || (part.contains("M2") && !part.contains("M1"));
  }

  private void addCalibration() {
    page.section("Can its probabilities be believed?");
    page.say(
        "What it says with a probability of 80\u00a0% should be true four times in "
            + "five. Then the points are on the diagonal. There are ten groups with equally "
            + "many cases; calibration.csv has them all.");
    for (String part : scores.parts()) {
      List<PagePicture> pictures = new ArrayList<>();
      diagnosis(part)
          .ifPresent(
              figures -> {
                pictures.add(CheckFigures.verdict(figures));
                pictures.add(CheckFigures.firstEffect(figures));
              });
      pictures.add(CheckFigures.shrinkage(part, casesOf(part)));
      page.pictures(pictures);
    }
  }

  private List<JsonNode> casesOf(String part) {
    boolean both = part.equals(scores.parts().get(0));
    return scores.cases().stream()
        .filter(one -> both || part.contains("(" + one.path("level").asText() + ")"))
        .toList();
  }

  private void addKinds() {
    page.section("Right, cautious, wrong");
    page.say(
        "Cautious: the verdict is undecided, or the right effects are named and the "
            + "diagnosis says that something is left. It claims nothing false.");
    scores.parts().forEach(part -> addCounts(part, "standings"));
    page.section("Kinds of cases and verdicts");
    scores.parts().forEach(part -> addCounts(part, "kinds"));
  }

  private void addConfusion() {
    String part = scores.parts().get(0);
    page.section("Effects and names");
    page.say(
        "Rows: the one effect that was at work. Columns: what the diagnosis said. It "
            + "does not know the names in brackets. Cases with several effects are in "
            + "confusion.csv.");
    diagnosis(part)
        .map(figures -> ConfusionTable.alone(figures.figures().path("confusion")))
        .ifPresent(
            counts ->
                page.add(
                    Html.styled("div", "upright", ConfusionTable.of("at work", part, counts))));
  }

  private void addCounts(String part, String field) {
    diagnosis(part)
        .map(figures -> figures.figures().path(field))
        .ifPresent(counts -> page.add(ConfusionTable.of("kind", part, counts)));
  }

  private void addWrong() {
    List<JsonNode> wrong =
        scores.cases().stream().filter(one -> !one.path("right").asBoolean()).toList();
    page.section("Answered wrongly: " + wrong.size());
    if (wrong.isEmpty()) {
      return;
    }
    Table table = Table.of("case", "level", "at work", "said", "#probability of the verdict");
    wrong.stream().limit(MOST_WRONG).forEach(one -> addWrong(table, one));
    page.add(Page.folded("All of them, with links to the diagnoses", table.html()));
    if (wrong.size() > MOST_WRONG) {
      page.soft("These are the first " + MOST_WRONG + "; all are in cases.csv.");
    }
  }

  private static void addWrong(Table table, JsonNode one) {
    String id = one.path("case").asText();
    boolean answered = one.has("verdict");
    table.row(
        answered ? Html.link("answers/" + id + "/report.html", id) : id,
        one.path("level").asText(),
        one.path("so").asText(),
        one.path("said").asText(),
        answered ? Measure.percent(one.path("verdict_probability").asDouble()) : NOTHING);
  }

  /** Nothing where no proposal was measured. */
  private void addNext() {
    if (next.isEmpty()) {
      return;
    }
    page.section("Do the proposed measurements tell effects apart?");
    page.say(
        "Where an answer proposed what to measure next, it was measured in the sealed world, "
            + "added to the readings, and diagnosed again. Rightly told apart: of the effects to "
            + "tell apart, those at work are named then, and no other of them.");
    Table counts = Table.of("what came of it", "#proposals", "#share", "#95\u00a0% interval");
    addOutcome(counts, "told apart rightly", "right");
    addOutcome(counts, "still tied, or undecided", "tied");
    addOutcome(counts, "told apart wrongly", "wrong");
    page.table(counts);
    Table table =
        Table.of("case", "at work", "to tell apart", "said before", "said after", "came of it");
    for (ToldApart one : next) {
      table.row(
          Html.link("next/answers/" + one.caseId() + "/report.html", one.caseId()),
          one.so(),
          one.separates().replace("+", ", "),
          one.saidBefore(),
          one.saidAfter(),
          one.outcome());
    }
    page.add(Page.folded("All of them, with links to the diagnoses after it", table.html()));
  }

  private void addOutcome(Table table, String words, String outcome) {
    Estimate share = ToldApart.share(next, outcome).estimate();
    table.row(
        words,
        share.counted(),
        Measure.percent(share.value()),
        Measure.percent(share.low()) + " to " + Measure.percent(share.high()));
  }

  private void addEffects() {
    String part = scores.parts().get(0);
    page.section("By effect, the worst first");
    page.say(
        "Cases with this effect alone that were explained by its name; for a name in "
            + "brackets, cases called unexplained. All cases of: ",
        part,
        ".");
    List<Html> lines = new ArrayList<>();
    diagnosis(part)
        .ifPresent(
            figures ->
                figures
                    .figures()
                    .path("effects_worst_first")
                    .forEach(line -> lines.add(effect(line))));
    page.add(Html.styled("div", "columns", Html.all(lines)));
  }

  /** From which size on effects are found; nothing where too few cases say. */
  private void addSizes() {
    String part = scores.parts().get(0);
    List<SizeFound> sizes = diagnosis(part).map(SizeFound::of).orElse(List.of());
    if (sizes.isEmpty()) {
      return;
    }
    page.section("From which size on effects are found");
    page.say(
        "Size 1 is a practical one. Effects alone; found is explained by its name. The "
            + "curve is logistic in the logarithm of the size, with a prior; a size beyond those "
            + "that were put in is not stated. In brackets the 95\u00a0% interval. Six cases or "
            + "more of each. All cases of: ",
        part, ".");
    Table table =
        Table.of(
            "effect",
            "#found",
            "#in 50 of 100 from size",
            "#in 90 of 100 from size",
            "#wrong names below",
            "#wrong names from there on");
    for (SizeFound one : sizes) {
      table.row(
          one.effect(),
          one.right() + " of " + one.cases(),
          size(one, one.half()),
          size(one, one.most()),
          one.below(),
          one.above());
    }
    page.table(table);
  }

  private static String size(SizeFound one, Estimate size) {
    return bounded(one, size.value())
        + " ("
        + bounded(one, size.low())
        + " to "
        + bounded(one, size.high())
        + ")";
  }

  /** In two digits, as far as sizes were put in. */
  private static String bounded(SizeFound one, double size) {
    if (size > one.greatest()) {
      return String.format(Locale.ROOT, "over %.1f", one.greatest());
    }
    return size < one.least()
        ? String.format(Locale.ROOT, "under %.2f", one.least())
        : String.format(Locale.ROOT, "%.2g", size);
  }

  private static Html effect(JsonNode line) {
    String counted = line.path("hits").asInt() + "\u00a0of\u00a0" + line.path("of").asInt();
    String interval =
        Measure.percent(line.path("low95").asDouble())
            + "\u00a0to\u00a0"
            + Measure.percent(line.path("high95").asDouble());
    return Html.styled(
        "div",
        "effect",
        line.path("effect").asText(),
        " ",
        Html.strong(counted),
        " ",
        Html.soft(interval));
  }

  private void addOrigin() {
    page.section("Settings and files");
    page.list(
        List.of(
            Html.code(order.command()),
            Html.of("program ", order.version()),
            Html.of("commitments: ", scores.commitments()),
            Html.of("all answers, SHA-256 ", Html.code(scores.answersSha256())),
            Html.of(
                "Intervals: Wilson's for shares, Hanley and McNeil's for AUROC, bootstrap "
                    + "elsewhere. With few cases a calibration error is above zero by chance alone."),
            Html.of(
                "Baseline: a trivial rule that names an effect by the largest kind of "
                    + "residual. Oracle: the world's own answer, and its own forecast of the sealed "
                    + "rows.")));
  }
}
