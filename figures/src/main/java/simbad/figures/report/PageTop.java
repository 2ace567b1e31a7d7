package simbad.figures.report;

import java.util.List;
import java.util.stream.Collectors;
import simbad.experiments.fidelity.FidelityLimits;
import simbad.experiments.fidelity.FidelityVerdict;
import simbad.experiments.fidelity.LimitCheck;
import simbad.experiments.report.TableName;
import simbad.experiments.run.RunResult;
import simbad.figures.markup.Markup;

/**
 * What a page says first.
 *
 * @param title markup, as all of the page
 * @param html below the title; may be empty
 */
record PageTop(String title, String html) {
  static final PageTop RUN = new PageTop("Edges followed with a simulated sonar", "");

  private static final String TABLE =
      """
      <div class="scroll" tabindex="0"><table>
      <thead><tr><th scope="col">obstacle (table)</th><th scope="col">limit on</th>
      <th scope="col">asked for</th><th scope="col">reached</th><th scope="col">held?</th></tr></thead>
      <tbody>
      """;

  /** The verdict on every result, then each limit with what was reached. */
  static PageTop verdict(List<RunResult> results, FidelityLimits limits) {
    StringBuilder html = new StringBuilder();
    results.forEach(result -> addVerdict(html, result, FidelityVerdict.of(result, limits)));
    html.append("<h2>Limits</h2>\n").append(TABLE);
    results.forEach(result -> addRows(html, result, FidelityVerdict.of(result, limits)));
    html.append("</tbody></table></div>\n");
    String sensors =
        results.stream()
            .map(result -> result.sensor().word())
            .distinct()
            .collect(Collectors.joining(", "));
    return new PageTop("Is the " + Markup.escaped(sensors) + " sensor faithful?", html.toString());
  }

  private static void addVerdict(StringBuilder html, RunResult result, FidelityVerdict verdict) {
    html.append("<p class=\"verdict")
        .append(verdict.passes() ? "" : " missed")
        .append("\"><strong>")
        .append(Markup.escaped(result.type().name() + ", " + result.sensor().word()))
        .append("</strong>: ")
        .append(Markup.escaped(verdict.sentence()))
        .append("</p>\n");
  }

  private static void addRows(StringBuilder html, RunResult result, FidelityVerdict verdict) {
    for (LimitCheck check : verdict.checks()) {
      html.append("<tr>");
      cell(html, TableName.of(result.type()));
      cell(html, check.what());
      cell(html, check.limit());
      cell(html, check.reached());
      html.append(check.isHeld() ? "<td>held</td>" : "<td><strong>missed</strong></td>");
      html.append("</tr>\n");
    }
  }

  private static void cell(StringBuilder html, String text) {
    html.append("<td>").append(Markup.escaped(text)).append("</td>");
  }
}
