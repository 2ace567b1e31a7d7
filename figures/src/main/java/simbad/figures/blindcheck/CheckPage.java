package simbad.figures.blindcheck;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import simbad.experiments.blindcheck.CheckOrder;
import simbad.experiments.blindcheck.CheckScores;
import simbad.experiments.blindcheck.CheckScores.Estimate;
import simbad.experiments.blindcheck.CheckScores.Figures;
import simbad.experiments.blindcheck.Measure;
import simbad.figures.diagnosis.Style;
import simbad.figures.markup.Markup;
import simbad.figures.plot.Figure;

/** The page of a check: one file, its first screen is the scoring table. */
final class CheckPage {
  private static final String LEVELS =
      """
      <p class="soft">Levels of independence: L0 the checker shares code with what it checks; <b>L1</b> independent code, the same
      equations; <b>L2</b> besides, other physics in the set-up; <b>L2w</b> echoes with a wave form and a receiver, and a user who
      calibrates; L3 a physical log. L1 finds faults of the
      program; only L2 and L3 tell how it will do elsewhere, and where they differ L2 is the one to believe. Robots that drive are <b>M1</b>,
      independent code and a robot as it is believed to be, and <b>M2</b>, a robot that is a little off by itself.</p>
      """;

  /** Two pixels to the point, for sharp screens. */
  private static final int SCREEN_DPI = 144;

  private final StringBuilder page = new StringBuilder();
  private final CheckOrder order;
  private final CheckScores scores;

  private CheckPage(CheckOrder order, CheckScores scores) {
    this.order = order;
    this.scores = scores;
  }

  static String of(CheckOrder order, CheckScores scores) {
    return new CheckPage(order, scores).text();
  }

  private String text() {
    page.append(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
            + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
            + "<title>The withheld check</title>\n<style>\n"
            + Style.SHEET
            + CheckStyle.SHEET
            + "</style>\n</head>\n<body>\n<main>\n");
    addHeadline();
    scores.parts().forEach(part -> addScores(part, Measure.ALL.subList(0, Measure.FIRST)));
    page.append(LEVELS);
    addCalibration();
    addKinds();
    addWrong();
    addEffects();
    addConfusion();
    page.append("<h2>Further scores</h2>\n");
    scores
        .parts()
        .forEach(part -> addScores(part, Measure.ALL.subList(Measure.FIRST, Measure.ALL.size())));
    addOrigin();
    return page.append("</main>\n</body>\n</html>\n").toString();
  }

  private Optional<Figures> diagnosis(String part) {
    return scores.figures(part, CheckScores.DIAGNOSIS);
  }

  private void addHeadline() {
    page.append("<h1>The withheld check of simbad diagnose</h1>\n");
    String part = scores.parts().get(0);
    Optional<Estimate> right = diagnosis(part).flatMap(f -> f.share("all verdicts right"));
    right.ifPresent(
        share ->
            page.append(
                "<p class=\"verdict\">Of data sets whose truth was sealed before the diagnosis, <b>"
                    + share.counted()
                    + "</b> got the right verdict: "
                    + Measure.percent(share.value())
                    + " (95&nbsp;% interval "
                    + Measure.percent(share.low())
                    + " to "
                    + Measure.percent(share.high())
                    + "). Independence: "
                    + Markup.escaped(part)
                    + ".</p>\n"));
    if (!order.withheld().isEmpty()) {
      note(
          "The diagnosis was not told of "
              + Markup.escaped(String.join(", ", order.withheld()))
              + ": such data must be called unexplained.");
    }
    long unanswered = scores.cases().stream().filter(one -> !one.has("verdict")).count();
    if (unanswered > 0) {
      note(
          unanswered == 1
              ? "1 case has no answer. It counts as wrong everywhere."
              : unanswered + " cases have no answer. They count as wrong everywhere.");
    }
  }

  private void note(String html) {
    page.append("<p class=\"note\">" + html + "</p>\n");
  }

  private void addScores(String part, List<Measure> measures) {
    page.append(
        "<h3 class=\"part\">"
            + Markup.escaped(part)
            + ", "
            + diagnosis(part).map(Figures::cases).orElse(0)
            + " cases</h3>\n<div class=\"scroll\" tabindex=\"0\"><table class=\"scores\">\n<thead><tr>"
            + "<th scope=\"col\">score</th><th scope=\"col\">diagnosis, 95&nbsp;% interval</th>"
            + "<th scope=\"col\">counted</th><th class=\"n\" scope=\"col\">to reach</th>"
            + "<th class=\"n\" scope=\"col\">baseline</th><th class=\"n\" scope=\"col\">oracle</th>"
            + "</tr></thead>\n<tbody>\n");
    measures.forEach(measure -> addScore(part, measure));
    page.append("</tbody></table></div>\n");
  }

  private void addScore(String part, Measure measure) {
    Optional<Estimate> found = diagnosis(part).flatMap(measure.of());
    if (found.isEmpty()) {
      return;
    }
    page.append("<tr><th scope=\"row\">" + Markup.escaped(measure.words()) + "</th>");
    page.append(ScoreCell.of(measure, found.get(), isOff(part)));
    for (String sort : CheckScores.SORTS.subList(1, CheckScores.SORTS.size())) {
      page.append(
          "<td class=\"n\">"
              + scores
                  .figures(part, sort)
                  .flatMap(measure.of())
                  .map(e -> measure.text(e.value()))
                  .orElse("&ndash;")
              + "</td>");
    }
    page.append("</tr>\n");
  }

  /** Whether all of a part's cases have a set-up that is itself a little off. */
  private static boolean isOff(String part) {
    return (part.contains("L2") && !part.contains("L1"))
        || (part.contains("M2") && !part.contains("M1"));
  }

  private void addCalibration() {
    page.append(
        "<h2>Are its probabilities to be believed?</h2>\n<p>Of what it says with 80&nbsp;%, four fifths"
            + " should be so: points belong on the diagonal. Ten groups of as many cases each; where numbers would"
            + " lie over each other they are left out, calibration.csv has them all.</p>\n");
    for (String part : scores.parts()) {
      page.append("<div class=\"figures\">\n");
      diagnosis(part)
          .ifPresent(
              figures -> {
                add(CheckFigures.verdict(figures));
                add(CheckFigures.firstEffect(figures));
              });
      add(CheckFigures.shrinkage(part, casesOf(part)));
      page.append("</div>\n");
    }
  }

  private List<JsonNode> casesOf(String part) {
    boolean both = part.equals(scores.parts().get(0));
    return scores.cases().stream()
        .filter(one -> both || part.contains("(" + one.path("level").asText() + ")"))
        .toList();
  }

  /** As pixels: with all letters as outlines the SVG would be four times as large. */
  private void add(Figure figure) {
    String words = Markup.escaped(figure.caption().title() + "; " + figure.caption().provenance());
    page.append(
        "<figure><img alt=\""
            + words
            + "\" width=\""
            + figure.widthPt()
            + "\" height=\""
            + figure.heightPt()
            + "\" src=\"data:image/png;base64,"
            + Base64.getEncoder().encodeToString(figure.png(SCREEN_DPI))
            + "\"></figure>\n");
  }

  private void addKinds() {
    page.append(
        "<h2>Right, cautious, wrong</h2>\n<p>Cautious: undecided, or the names are there and"
            + " something is said to be left; it claims nothing that is not so.</p>\n");
    scores.parts().forEach(part -> addCounts(part, "standings"));
    page.append("<h2>What was taken for what</h2>\n");
    scores.parts().forEach(part -> addCounts(part, "kinds"));
  }

  private void addConfusion() {
    String part = scores.parts().get(0);
    page.append(
        "<h2>Effects and names</h2>\n<p>What was at work alone, down; what was said, across. Names in"
            + " brackets the diagnosis does not have. Several at once are in confusion.csv.</p>\n");
    diagnosis(part)
        .map(figures -> ConfusionTable.alone(figures.figures().path("confusion")))
        .ifPresent(
            counts ->
                page.append(
                    "<div class=\"upright\">"
                        + ConfusionTable.of("at work", Markup.escaped(part), counts)
                        + "</div>\n"));
  }

  private void addCounts(String part, String field) {
    diagnosis(part)
        .map(figures -> figures.figures().path(field))
        .ifPresent(counts -> page.append(ConfusionTable.of("kind", Markup.escaped(part), counts)));
  }

  private void addWrong() {
    List<JsonNode> wrong =
        scores.cases().stream().filter(one -> !one.path("right").asBoolean()).toList();
    page.append("<h2>Answered wrongly: " + wrong.size() + "</h2>\n");
    if (wrong.isEmpty()) {
      return;
    }
    page.append(
        "<details><summary>Each case, with its diagnosis</summary>\n<div class=\"scroll\" tabindex=\"0\"><table>\n"
            + "<thead><tr><th scope=\"col\">case</th><th scope=\"col\">level</th>"
            + "<th scope=\"col\">at work</th><th scope=\"col\">said</th>"
            + "<th scope=\"col\">probability of the verdict</th></tr></thead>\n<tbody>\n");
    for (JsonNode one : wrong) {
      String id = Markup.escaped(one.path("case").asText());
      boolean answered = one.has("verdict");
      page.append(
          "<tr><td>"
              + (answered ? "<a href=\"answers/" + id + "/report.html\">" + id + "</a>" : id)
              + "</td><td>"
              + Markup.escaped(one.path("level").asText())
              + "</td><td>"
              + Markup.escaped(one.path("so").asText())
              + "</td><td>"
              + Markup.escaped(one.path("said").asText())
              + "</td><td class=\"n\">"
              + (answered ? Measure.percent(one.path("verdict_probability").asDouble()) : "&ndash;")
              + "</td></tr>\n");
    }
    page.append("</tbody></table></div></details>\n");
  }

  private void addEffects() {
    String part = scores.parts().get(0);
    page.append(
        "<h2>By effect, the worst first</h2>\n<p>Alone and named and explained; in brackets: called"
            + " unexplained. These are "
            + Markup.escaped(part)
            + ".</p>\n<div class=\"columns\">\n");
    diagnosis(part)
        .ifPresent(
            figures ->
                figures
                    .figures()
                    .path("effects_worst_first")
                    .forEach(
                        line ->
                            page.append(
                                "<div>"
                                    + Markup.escaped(line.path("effect").asText())
                                    + " <b>"
                                    + line.path("hits").asInt()
                                    + "&nbsp;of&nbsp;"
                                    + line.path("of").asInt()
                                    + "</b> <span class=\"soft\">"
                                    + Measure.percent(line.path("low95").asDouble())
                                    + "&nbsp;to&nbsp;"
                                    + Measure.percent(line.path("high95").asDouble())
                                    + "</span></div>\n")));
    page.append("</div>\n");
  }

  private void addOrigin() {
    page.append("<h2>How this was made</h2>\n<ul>\n");
    item("<code>" + Markup.escaped(order.command()) + "</code>");
    item("program " + Markup.escaped(order.version()));
    item("commitments: " + Markup.escaped(scores.commitments()));
    item("all answers, SHA-256 <code>" + Markup.escaped(scores.answersSha256()) + "</code>");
    item(
        "Intervals: Wilson's for shares, Hanley and McNeil's for AUROC, bootstrap elsewhere. A"
            + " calibration error of few cases is above nought by chance alone.");
    item(
        "Baseline: names the largest sort of residual. Oracle: the world's own answer, and its own"
            + " forecast of the sealed rows.");
    page.append("</ul>\n");
  }

  private void item(String html) {
    page.append("<li>" + html + "</li>\n");
  }
}
