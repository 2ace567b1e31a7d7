package simbad.figures.batch;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToLongFunction;
import simbad.experiments.batch.BatchSurvey;
import simbad.experiments.batch.BatchSurvey.Group;
import simbad.experiments.report.ErrorWords;
import simbad.figures.page.Html;
import simbad.figures.page.Page;
import simbad.figures.page.Table;

/** A batch on one page, however many runs it has. */
final class BatchPage {
  /** What a page of 300 kB can hold; a batch of so many groups is looked at with a program. */
  private static final int MOST_GROUPS = 300;

  private static final int MOST_PICTURES = 24;
  private static final int MOST_WORDS = 240;

  private final Page page = new Page("A batch of runs", "A batch of runs");
  private final BatchSurvey survey;

  private BatchPage(BatchSurvey survey) {
    this.survey = survey;
  }

  static String of(BatchSurvey survey, String version) {
    BatchPage own = new BatchPage(survey);
    own.addVerdict();
    own.addPictures();
    own.addTable();
    own.addWrong();
    own.page.section("Files and program");
    own.page.soft("Program ", version, ". All rows are in results.csv, the spec in spec.json.");
    return own.page.html();
  }

  private long sum(ToLongFunction<Group> count) {
    return survey.groups().stream().mapToLong(count).sum();
  }

  private void addVerdict() {
    Html runs = Html.strong(survey.runs() == 1 ? "1 run" : survey.runs() + " runs");
    if (survey.wrongRuns() == 0) {
      page.verdict(runs, ": all completed their round, and nothing went wrong.");
    } else {
      page.missed(
          runs,
          ": ",
          sum(Group::failed),
          " failed, ",
          sum(Group::unclosed),
          " did not complete the round, ",
          sum(Group::lost),
          " completed the round but did not keep the edge.");
    }
  }

  /** Per obstacle a bar for each sensor. */
  private void addPictures() {
    Map<String, List<Group>> byObstacle = new LinkedHashMap<>();
    survey.groups().stream()
        .limit(MOST_GROUPS)
        .forEach(
            group ->
                byObstacle.computeIfAbsent(group.obstacle(), name -> new ArrayList<>()).add(group));
    page.section("Mean radial error");
    page.pictures(
        byObstacle.entrySet().stream()
            .limit(MOST_PICTURES)
            .map(entry -> ErrorBars.of(entry.getKey(), entry.getValue()))
            .toList());
  }

  private void addTable() {
    Table table =
        Table.of(
            "obstacle",
            "sensor",
            "#runs",
            "#failed",
            "#round not completed",
            "#edge not kept",
            "#" + ErrorWords.MEAN,
            "#" + ErrorWords.MAX);
    survey.groups().stream().limit(MOST_GROUPS).forEach(group -> add(table, group));
    page.section("By obstacle and sensor").table(table);
    page.soft(
        "mean: mean of the runs' mean radial errors |r - T|; max: the greatest of all. "
            + "Edge not kept: the trace came within 5 cm of less than 95\u00a0% of the edge.");
  }

  private static void add(Table table, Group group) {
    table.row(
        group.obstacle(),
        group.sensor(),
        group.runs(),
        group.failed(),
        group.unclosed(),
        group.lost(),
        ErrorBars.number(group.meanCm()),
        ErrorBars.number(group.maxCm()));
  }

  private void addWrong() {
    page.section("Runs that went wrong: " + survey.wrongRuns());
    if (survey.wrong().isEmpty()) {
      return;
    }
    Table table = Table.of("#run", "obstacle", "sensor", "settings", "what");
    survey
        .wrong()
        .forEach(
            one ->
                table.row(
                    one.number(),
                    one.obstacle(),
                    one.sensor(),
                    one.settings(),
                    shortened(one.what())));
    page.table(table);
    if (survey.wrong().size() < survey.wrongRuns()) {
      page.soft("The first " + survey.wrong().size() + " are listed here; all are in results.csv.");
    }
  }

  /** An error may be as long as a program likes. */
  private static String shortened(String what) {
    return what.length() <= MOST_WORDS ? what : what.substring(0, MOST_WORDS - 1) + "…";
  }
}
