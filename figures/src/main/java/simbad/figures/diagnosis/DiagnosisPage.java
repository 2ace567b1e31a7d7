package simbad.figures.diagnosis;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import simbad.figures.markup.Markup;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.DiagnosisJson;
import simbad.gap.diagnosis.NextExperiment;
import simbad.gap.diagnosis.Provenance;
import simbad.gap.diagnosis.SetupError;
import simbad.sonar.effect.Definitions;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.sensing.ReadingRow;

/**
 * A diagnosis's page: the answer on the first screen, then where, how well, what next, from what.
 */
final class DiagnosisPage {
  private static final int MOST_MAPS = 4;
  private static final double LEAST_SCALE_CM = 0.5;

  private final Diagnosis diagnosis;
  private final DataSet data;
  private final List<RowFinding> rows;
  private final StringBuilder page = new StringBuilder();

  private DiagnosisPage(Diagnosis diagnosis, DataSet data, List<RowFinding> rows) {
    this.diagnosis = diagnosis;
    this.data = data;
    this.rows = rows;
  }

  /**
   * Returns the page as HTML.
   *
   * @param diagnosis what was found
   * @param data what it was found in
   * @param rows all rows before and after; at least one
   * @param provenance what it was made by
   */
  static String of(
      Diagnosis diagnosis, DataSet data, List<RowFinding> rows, Provenance provenance) {
    DiagnosisPage page = new DiagnosisPage(diagnosis, data, rows);
    page.page.append(Style.head(Markup.escaped(data.name()) + ": " + diagnosis.verdict().word()));
    page.page.append("<h1>Simulation and reality: " + Markup.escaped(data.name()) + "</h1>\n");
    AuditSection.add(page.page, diagnosis.audit(), data.name());
    FirstScreen.add(page.page, diagnosis, data);
    page.where();
    page.residuals();
    page.effects();
    page.next();
    page.tried();
    page.origin(provenance);
    return page.page.append("</main>\n</body>\n</html>\n").toString();
  }

  private void where() {
    page.append("<h2>Where the gap lies</h2>\n");
    new Tables(page).places(diagnosis.where());
    page.append(
        "<p><span class=\"key before\"></span> simulator as it is"
            + " &nbsp; <span class=\"key after\"></span> diagnosed model."
            + " The figures show all rows, the fitted ones too; the sizes above are of held-out"
            + " rows only.</p>\n");
    page.append("<div class=\"figures\">\n");
    List<Obstacle> obstacles = data.setup().scene().obstacles();
    for (int i = 0; i < Math.min(MOST_MAPS, obstacles.size()); i++) {
      maps(i, obstacles.get(i));
    }
    graph(
        "By distance", "distance to the nearest obstacle's centre, m", 0.02, RowFinding::distanceM);
    graph("By off-axis angle", "angle off the axis, degrees", 0.5, RowFinding::offAxisDeg);
    if (data.readings().stream().allMatch(ReadingRow::isTimed)) {
      graph("By time", "time since the run's begin, s", 0.5, row -> OptionalDouble.of(row.timeS()));
      graph("By speed", "sensor's speed, m/s", 0.02, row -> OptionalDouble.of(row.speedMPerS()));
    }
    page.append("</div>\n");
    if (obstacles.size() > MOST_MAPS) {
      page.append(
          "<p class=\"soft\">Maps are drawn of the first " + MOST_MAPS + " obstacles only.</p>\n");
    }
  }

  private void maps(int index, Obstacle obstacle) {
    List<RowFinding> near = rows.stream().filter(row -> row.obstacle() == index).toList();
    if (near.isEmpty()) {
      return;
    }
    PolarMap map = new PolarMap(obstacle, near);
    double most =
        Math.max(
            map.greatestCm(row -> row.before().gapCm()),
            map.greatestCm(row -> row.after().gapCm()));
    AxisScale scale = AxisScale.over(0, Math.max(most, LEAST_SCALE_CM), 4);
    String round = ": round the obstacle " + obstacle.name();
    figure(
        "Before" + round,
        map.draw("Gap before" + round, row -> row.before().gapCm(), scale),
        "Mean gap by bearing and distance, in the obstacle's own frame. Dashed: the threshold that"
            + " the simulator believes.");
    figure(
        "After" + round,
        map.draw("Gap after" + round, row -> row.after().gapCm(), scale),
        "The same under the diagnosed model, in the same colours.");
  }

  private void graph(
      String heading, String axis, double least, Function<RowFinding, OptionalDouble> quantity) {
    Optional<String> graph = GapGraph.of(axis, least, rows, quantity);
    graph.ifPresent(svg -> figure(heading, svg, "Bins of fewer than three rows are left out."));
  }

  private void residuals() {
    page.append("<h2>How well the models forecast</h2>\n<div class=\"figures\">\n");
    figure(
        "Ranks",
        ResidualGraph.ranks(rows),
        "Where each reading lies in its forecast, a no-echo behind all ranges. Forecasts that hold"
            + " give the dashed line; a heap at 1 means echoes that did not come or came too late.");
    ResidualGraph.ranges(rows)
        .ifPresent(
            svg ->
                figure(
                    "Ranges",
                    svg,
                    "Echoes that were read, less the median of those expected. A shift is a wrong"
                        + " range, a second heap another way or another object."));
    page.append("</div>\n");
  }

  private void effects() {
    page.append("<h2>What was fitted</h2>\n");
    new Tables(page).parameters(diagnosis);
    if (diagnosis.calibration().size() > 0) {
      page.append(
          "<p>The set-up itself was calibrated on the reference readings before: "
              + diagnosis.calibration().forms().size()
              + " forms, in "
              + DiagnosisJson.FILE
              + ".</p>\n");
    }
    diagnosis.setupError().ifPresent(this::setupError);
    page.append("<h2>What these data could not have shown</h2>\n");
    new Tables(page).undetectable(diagnosis.undetectable());
  }

  private void setupError(SetupError error) {
    page.append(
        "<p>The sensor is taken to hear by the "
            + diagnosis.model().word()
            + " law. On readings of the reference that it was not fitted on it is "
            + Html.number(error.gapCm())
            + " cm off, where it expects "
            + Html.number(error.expectedCm())
            + " cm; evidence counts for less by as much as blocks of these readings vary more than"
            + " chance.</p>\n");
  }

  private void next() {
    page.append("<h2>What to measure next</h2>\n");
    if (diagnosis.nextExperiment().isEmpty()) {
      page.append(
          "<p>Nothing is tied: no further measurement is needed to tell effects apart.</p>\n");
      return;
    }
    NextExperiment next = diagnosis.nextExperiment().get();
    page.append(
        "<p>To tell "
            + Html.list(next.separates())
            + " apart, measure at the "
            + next.poses().size()
            + " poses of <code>"
            + DiagnosisJson.POSES
            + "</code> beside this page: they are expected to bring "
            + Html.number(next.expectedLogOdds())
            + " nats of evidence, whichever of them is true.</p>\n<div class=\"figures\">\n");
    figure(
        "Poses to measure at",
        PosePlan.of(next.poses(), data.setup().scene()),
        "Seen from above; each dot is a ping, its line points where the sensor looks.");
    page.append("</div>\n");
  }

  private void tried() {
    page.append("<h2>What was tried</h2>\n");
    new Tables(page).tried(diagnosis.tried());
    int effects = Definitions.effects().size();
    int all = effects * (effects - 1) / 2;
    long pairs = diagnosis.tried().stream().filter(one -> one.effects().size() == 2).count();
    page.append(
        "<p class=\"soft\">"
            + diagnosis.tried().size()
            + " sets are scored on rows they were not fitted on ("
            + pairs
            + " of "
            + all
            + " pairs), above the simulator as it is; the best stand here, all in "
            + DiagnosisJson.FILE
            + ". Sets that are not there were ruled out before, by fits that were worse.</p>\n");
  }

  private void origin(Provenance provenance) {
    page.append("<h2>What this was made of</h2>\n<ul>\n");
    item("program " + Markup.escaped(provenance.version()) + ", seed " + provenance.seed());
    item(
        data.readings().size()
            + " readings, "
            + (data.reference().isEmpty()
                ? "no reference"
                : data.reference().size() + " reference readings"));
    provenance
        .sha256()
        .forEach(
            (name, hash) -> item(Markup.escaped(name) + ", SHA-256 <code>" + hash + "</code>"));
    page.append("</ul>\n");
    page.append(
        "<p class=\"soft\">A gap is twice the mean pinball loss of 19 predicted quantiles of the"
            + " reading (the continuous ranked probability score by quantiles), a no-echo counted as "
            + Html.number(data.setup().noEchoM())
            + "&nbsp;m.</p>\n");
  }

  private void figure(String heading, String svg, String caption) {
    page.append(
        "<figure><h3>"
            + Markup.escaped(heading)
            + "</h3>\n"
            + svg
            + "<figcaption>"
            + caption
            + "</figcaption></figure>\n");
  }

  private void item(String text) {
    page.append("<li>" + text + "</li>\n");
  }
}
