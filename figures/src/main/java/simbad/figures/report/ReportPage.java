package simbad.figures.report;

import static java.util.stream.Collectors.joining;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import simbad.experiments.control.Tuning;
import simbad.experiments.report.ErrorRecord;
import simbad.experiments.report.RunFiles;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.report.TableName;
import simbad.experiments.run.DetectionMap;
import simbad.experiments.run.EdgeLoss;
import simbad.experiments.run.ErrorParts;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.SensorKind;
import simbad.experiments.run.TraceMove;
import simbad.figures.markup.Markup;
import simbad.obstacles.ObstacleType;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.format.TextFile;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.DetectionShadow;

/** A run's page: what was asked, the figures, the pictures, and how to read each. */
final class ReportPage {
  private static final String HEAD =
      """
      <!DOCTYPE html>
      <html lang="en">
      <head>
      <meta charset="utf-8">
      <meta name="viewport" content="width=device-width, initial-scale=1">
      <title>%TITLE%</title>
      <style>
      :root { color-scheme: light dark; }
      body { font: 16px/1.5 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem; }
      table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: .9rem; }
      th, td { padding: .25rem .5rem; border-bottom: 1px solid #8886; text-align: right; }
      th:first-child, td:first-child, th:nth-child(2), td:nth-child(2) { text-align: left; }
      figure { margin: 1rem 0; }
      figure img { max-width: 100%; height: auto; }
      figcaption { max-width: 46rem; }
      .scroll { overflow-x: auto; }
      code, li { overflow-wrap: anywhere; }
      .maps { display: grid; grid-template-columns: repeat(auto-fit, minmax(18rem, 1fr)); gap: 1rem; }
      .note { border-left: 4px solid #d55e00; padding-left: .8rem; }
      .verdict { border-left: 4px solid #0072b2; padding-left: .8rem; font-size: 1.1rem; }
      .verdict.missed { border-color: #d55e00; }
      """
          + Markup.PLOT_STYLE
          + """
      </style>
      </head>
      <body>
      <main>
      <h1>%TITLE%</h1>
      """;

  private static final String LIMITS =
      """
      <p class="note">No robot was ever traced round these obstacles in reality. The traces show what
      follows from a threshold table; they do not test the table. The measured table has steps of
      2&nbsp;cm and is a single sweep of one sensor (Kranz 2014). Tables marked <em>reconstructed</em>
      were never published as numbers.</p>
      """;

  private static final double WORTH_SAYING = 0.01;

  private ReportPage() {}

  static void write(
      Path file,
      PageTop top,
      RunOrigin origin,
      Map<String, String> hashes,
      Map<String, List<RunResult>> byObstacle)
      throws IOException {
    StringBuilder page = new StringBuilder(HEAD.replace("%TITLE%", top.title()));
    page.append(top.html());
    page.append(LIMITS);
    addErrors(page, byObstacle);
    byObstacle.values().forEach(results -> addObstacle(page, results));
    addOrigin(page, origin, hashes);
    page.append("</main>\n</body>\n</html>\n");
    TextFile.write(file, page.toString());
  }

  private static void addErrors(StringBuilder page, Map<String, List<RunResult>> byObstacle) {
    boolean isCompared = hasReduction(byObstacle);
    String reduction = isCompared ? "<th scope=\"col\">smaller than original by</th>\n" : "";
    String head =
        """
        <h2>Errors against the tables</h2>
        <div class="scroll" tabindex="0"><table>
        <thead><tr><th scope="col">obstacle (table)</th><th scope="col">sensor</th>
        <th scope="col">mean |r&minus;T|, cm</th><th scope="col">RMS, cm</th><th scope="col">median, cm</th>
        <th scope="col">maximum, cm</th><th scope="col">lateral mean, cm</th><th scope="col">lateral 95&nbsp;%, cm</th>
        <th scope="col">edge kept</th><th scope="col">edge to trace, maximum, cm</th>
        <th scope="col">bearings not reached</th>%REDUCTION%
        <th scope="col">map agrees</th></tr></thead>
        <tbody>
        """;
    page.append(head.replace("%REDUCTION%\n", reduction));
    byObstacle
        .values()
        .forEach(results -> results.forEach(result -> addRow(page, result, isCompared)));
    page.append(
        """
        </tbody></table></div>
        <p>Radial error: for each bearing of the table the mean of |r &minus; T| over all crossings of that
        bearing; then mean, root mean square, median and maximum over the bearings. It is harsh where the
        edge runs nearly along the bearing. Lateral error: distance of the trace from the shadow's edge.
        Edge kept: the share of the edge's length that has a place of the trace within 5 cm. A lobe that
        was cut off shows there, and in the greatest distance from the edge to the trace.
        The map's agreement is the share of places and headings at which the belt hears the obstacle
        exactly where the table says.</p>
        """);
    byObstacle.values().stream()
        .flatMap(results -> EdgeLoss.of(results).stream())
        .forEach(loss -> page.append("<p>" + Markup.escaped(loss.sentence()) + "</p>\n"));
  }

  /** Without an original sensor there is nothing to be smaller than. */
  private static boolean hasReduction(Map<String, List<RunResult>> byObstacle) {
    return byObstacle.values().stream()
        .flatMap(List::stream)
        .filter(result -> !result.sensor().equals(SensorKind.ORIGINAL))
        .anyMatch(result -> result.reductionVsOriginal().isPresent());
  }

  private static void addRow(StringBuilder page, RunResult result, boolean isCompared) {
    ErrorRecord row = ErrorRecord.of(result);
    String name = Markup.escaped(TableName.of(result.type()));
    page.append("<tr><td>" + name + "</td><td>" + row.sensor() + "</td>");
    cell(page, number(row.meanAbsCm()));
    cell(page, number(row.rmsCm()));
    cell(page, number(row.medianAbsCm()));
    cell(page, number(row.maxAbsCm()));
    cell(page, number(row.lateralMeanCm()));
    cell(page, number(row.lateralP95Cm()));
    cell(page, percent(row.edgeKept(), 1));
    cell(page, number(row.edgeToTraceMaxCm()));
    cell(page, row.unreachedBearings() + " of " + row.bearings());
    if (isCompared) {
      cell(page, percent(row.reductionVsOriginal(), 1));
    }
    cell(page, percent(OptionalDouble.of(row.mapAgreement()), 2));
    page.append("</tr>\n");
  }

  private static void cell(StringBuilder page, String text) {
    page.append("<td>" + text + "</td>");
  }

  private static String number(OptionalDouble value) {
    return value.isPresent() ? RunFiles.fixed(value.getAsDouble(), 2) : "&ndash;";
  }

  private static String percent(OptionalDouble share, int decimals) {
    return share.isPresent()
        ? RunFiles.fixed(100 * share.getAsDouble(), decimals) + "&nbsp;%"
        : "&ndash;";
  }

  private static void addObstacle(StringBuilder page, List<RunResult> results) {
    ObstacleType type = results.get(0).type();
    String name = Markup.escaped(type.name());
    page.append("<h2>" + name + "</h2>\n");
    page.append("<p>Table " + type.thresholds().provenanceWord());
    type.thresholds().header("source").ifPresent(text -> page.append(": " + Markup.escaped(text)));
    page.append(".</p>\n");
    results.stream()
        .filter(result -> !result.trace().isClosed())
        .forEach(result -> addLost(page, result));
    results.forEach(result -> addMissed(page, result));
    TraceMove.of(results).forEach(move -> note(page, Markup.escaped(move.sentence())));
    ErrorParts.of(results).forEach(parts -> note(page, Markup.escaped(parts.sentence())));
    results.forEach(result -> addIdle(page, result));
    figure(
        page,
        name + "/polar",
        "Where the robot drove, seen from above. A sensor that hears what the table says drives along"
            + " the table's edge.");
    figure(page, name + "/errors", errorCaption(results));
    page.append("<div class=\"maps\">\n");
    for (RunResult result : results) {
      figure(
          page,
          name + "/map-" + result.sensor().word(),
          "Share of "
              + DetectionMap.HEADINGS
              + " random headings at which the "
              + result.sensor().word()
              + " belt and the table disagree; pale is agreement. A sensor nearer than its least range hears"
              + " nothing.");
    }
    page.append("</div>\n");
  }

  /** Says of the picture only what is on it. */
  private static String errorCaption(List<RunResult> results) {
    return "Radial error by bearing"
        + (RunPictures.errorPlot(results).isLogarithmic() ? ", logarithmic" : "")
        + ". Where the edge runs nearly along a bearing, a small distance from the edge is a large"
        + " radial error.";
  }

  private static void addLost(StringBuilder page, RunResult result) {
    page.append(
        "<p class=\"note\">With the "
            + result.sensor().word()
            + " sensor the robot did not get round: "
            + result.errors().unreachedBearings()
            + " of "
            + result.errors().radialM().size()
            + " bearings were never reached. Its errors are over the others.</p>\n");
  }

  /** Thin rays pass a post between them; a sensor of short range does not hear far places. */
  private static void addMissed(StringBuilder page, RunResult result) {
    DetectionShadow shadow = new DetectionShadow(result.type().thresholds().table());
    double missed = result.map().missedShare(shadow);
    if (missed >= WORTH_SAYING) {
      page.append(
          "<p class=\"note\">The "
              + result.sensor().word()
              + " sensor missed the obstacle at "
              + percent(OptionalDouble.of(missed), 1)
              + " of the map's places and headings at which the table says that it is heard.</p>\n");
    }
  }

  /** What was found of one obstacle holds for those of its name only. */
  private static void addIdle(StringBuilder page, RunResult result) {
    List<FittedForm> idle = result.idleForms();
    if (!idle.isEmpty()) {
      note(
          page,
          "Of the "
              + result.sensor().word()
              + " sensor's model "
              + Markup.escaped(
                  idle.stream().map(one -> one.form().toString()).collect(joining(", ")))
              + " is about an obstacle that is not in this world, and changes nothing in it.");
    }
  }

  private static void note(StringBuilder page, String text) {
    page.append("<p class=\"note\">" + text + "</p>\n");
  }

  private static void figure(StringBuilder page, String name, String caption) {
    page.append(
        "<figure><a href=\""
            + name
            + ".svg\"><img src=\""
            + name
            + ".png\" alt=\""
            + caption
            + "\"></a><figcaption>"
            + caption
            + "</figcaption></figure>\n");
  }

  private static void addOrigin(StringBuilder page, RunOrigin origin, Map<String, String> hashes) {
    SonarSpec sonar = origin.settings().sonar();
    page.append("<h2>How this was made</h2>\n<ul>\n");
    item(page, "program " + Markup.escaped(origin.version()));
    item(page, "seed " + origin.settings().seed());
    if (origin.settings().waitS() > 0) {
      item(page, "the robot stands still for " + origin.settings().waitS() + " s after each step");
    }
    item(
        page,
        "robot: "
            + SensorKind.SONARS
            + " sonars at its centre, all round; "
            + origin.settings().speedMPerS()
            + " m/s, in bends at most "
            + Tuning.BEND_SPEED_M_PER_S
            + " m/s, steps of 0.05 s; slower is nearer");
    item(
        page,
        "sonar "
            + Markup.escaped(sonar.name())
            + ": cone half-angle "
            + RunFiles.fixed(Math.toDegrees(sonar.coneHalfAngleRad()), 1)
            + "&deg;, range "
            + sonar.minRangeM()
            + " to "
            + sonar.maxRangeM()
            + " m");
    for (SensorKind kind : origin.settings().sensors()) {
      item(page, kind.word() + " sensor: " + Markup.escaped(kind.meaning()));
    }
    hashes.forEach(
        (name, hash) ->
            item(page, Markup.escaped(name) + "/table.csv, SHA-256 <code>" + hash + "</code>"));
    page.append("</ul>\n");
  }

  private static void item(StringBuilder page, String text) {
    page.append("<li>" + text + "</li>\n");
  }
}
