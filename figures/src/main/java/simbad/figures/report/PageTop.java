package simbad.figures.report;

import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import simbad.experiments.fidelity.FidelityLimits;
import simbad.experiments.fidelity.FidelityVerdict;
import simbad.experiments.fidelity.LimitCheck;
import simbad.experiments.report.TableName;
import simbad.experiments.run.RunResult;
import simbad.figures.page.Html;
import simbad.figures.page.Page;
import simbad.figures.page.Table;

/**
 * What a page says first.
 *
 * @param title of the page
 * @param first adds what stands below it
 */
record PageTop(String title, Consumer<Page> first) {
  static final PageTop RUN = new PageTop("Edges followed with a simulated sonar", page -> {});

  /** The verdict on every result, then each limit with what was reached. */
  static PageTop verdict(List<RunResult> results, FidelityLimits limits) {
    String sensors =
        results.stream()
            .map(result -> result.sensor().word())
            .distinct()
            .collect(Collectors.joining(", "));
    return new PageTop(
        "Is the " + sensors + " sensor faithful?", page -> add(page, results, limits));
  }

  private static void add(Page page, List<RunResult> results, FidelityLimits limits) {
    results.forEach(result -> addVerdict(page, result, FidelityVerdict.of(result, limits)));
    Table table = Table.of("obstacle (table)", "limit on", "asked for", "reached", "held?");
    results.forEach(result -> addRows(table, result, FidelityVerdict.of(result, limits)));
    page.section("Limits").table(table);
  }

  private static void addVerdict(Page page, RunResult result, FidelityVerdict verdict) {
    Html who = Html.strong(result.type().name() + ", " + result.sensor().word());
    if (verdict.passes()) {
      page.verdict(who, ": ", verdict.sentence());
    } else {
      page.missed(who, ": ", verdict.sentence());
    }
  }

  private static void addRows(Table table, RunResult result, FidelityVerdict verdict) {
    for (LimitCheck check : verdict.checks()) {
      table.row(
          TableName.of(result.type()),
          check.what(),
          check.limit(),
          check.reached(),
          check.isHeld() ? "held" : Html.strong("missed"));
    }
  }
}
