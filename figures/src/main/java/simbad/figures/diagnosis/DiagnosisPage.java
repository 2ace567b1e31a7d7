package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Page;
import simbad.figures.page.PagePicture;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.DiagnosisJson;
import simbad.gap.diagnosis.DiagnosisProvenance;
import simbad.gap.diagnosis.NextExperiment;
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
  private final Page page;

  private DiagnosisPage(Page page, Diagnosis diagnosis, DataSet data, List<RowFinding> rows) {
    this.page = page;
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
      Diagnosis diagnosis, DataSet data, List<RowFinding> rows, DiagnosisProvenance provenance) {
    Page page =
        new Page(
            data.name() + ": " + diagnosis.verdict().word(),
            "Simulation and reality: " + data.name() + " (" + diagnosis.verdict().word() + ")");
    AuditSection.add(page, diagnosis.audit(), data.name());
    add(page, diagnosis, data, rows);
    new DiagnosisPage(page, diagnosis, data, rows).origin(provenance);
    return page.html();
  }

  /** Adds all but the audit and what it was made of. */
  static void add(Page page, Diagnosis diagnosis, DataSet data, List<RowFinding> rows) {
    DiagnosisPage own = new DiagnosisPage(page, diagnosis, data, rows);
    FirstScreen.add(page, diagnosis, data);
    own.where();
    own.residuals();
    own.effects();
    own.next();
    own.tried();
  }

  private void where() {
    page.section("Where the gap lies");
    new Tables(page).places(diagnosis.where());
    page.say(
        Html.key("before"),
        " simulator as it is \u00a0 ",
        Html.key("after"),
        " diagnosed model. The pictures show all rows, also those used for the fit. "
            + "The gaps above are from held-out rows only, which the fit never saw."
            + (diagnosis.calibration().size() > 0 && !data.reference().isEmpty()
                ? " They begin at the set-up as its reference shows it. The simulator as it is "
                    + "does not know the reference; the diagnosed model does."
                : ""));
    List<PagePicture> pictures = new ArrayList<>();
    List<Obstacle> obstacles = data.setup().scene().obstacles();
    LadderPart ladder = LadderPart.of(data, rows);
    if (!ladder.isEmpty()) {
      ladder.say(page);
      pictures.add(ladder.picture());
    }
    for (int i = 0; ladder.isEmpty() && i < Math.min(MOST_MAPS, obstacles.size()); i++) {
      addMaps(pictures, i, obstacles.get(i));
    }
    addGraphs(pictures);
    page.pictures(pictures);
    if (ladder.isEmpty() && obstacles.size() > MOST_MAPS) {
      page.soft("Only the first " + MOST_MAPS + " obstacles have maps.");
    }
  }

  private void addMaps(List<PagePicture> pictures, int index, Obstacle obstacle) {
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
    pictures.add(
        new PagePicture(
            "Before" + round,
            map.draw("Gap before" + round, row -> row.before().gapCm(), scale),
            "Mean gap by bearing and distance, in the obstacle's own frame. Dashed line: "
                + "the threshold that the simulator believes."));
    pictures.add(
        new PagePicture(
                "After" + round,
                map.draw("Gap after" + round, row -> row.after().gapCm(), scale),
                "The same with the diagnosed model, in the same colours.")
            .with("Both by bearing, as a table", map.table()));
  }

  private void addGraphs(List<PagePicture> pictures) {
    addGraph(
        pictures,
        "By distance",
        GapGraph.of(
            "distance to the nearest obstacle's centre, m", 0.02, rows, RowFinding::distanceM));
    addGraph(
        pictures,
        "By off-axis angle",
        GapGraph.of("angle off the axis, degrees", 0.5, rows, RowFinding::offAxisDeg));
    if (data.readings().stream().allMatch(ReadingRow::isTimed)) {
      addGraph(
          pictures,
          "By time",
          GapGraph.of(
              "time since the start of the run, s",
              0.5,
              rows,
              row -> OptionalDouble.of(row.timeS())));
      addGraph(
          pictures,
          "By speed",
          GapGraph.of(
              "sensor's speed, m/s", 0.02, rows, row -> OptionalDouble.of(row.speedMPerS())));
    }
  }

  private static void addGraph(List<PagePicture> pictures, String heading, Optional<Html> graph) {
    graph.ifPresent(
        drawing ->
            pictures.add(
                new PagePicture(
                    heading, drawing, "Bins with fewer than three rows are left out.")));
  }

  private void residuals() {
    page.section("How well the models forecast");
    List<PagePicture> pictures = new ArrayList<>();
    pictures.add(
        new PagePicture(
            "Ranks",
            ResidualGraph.ranks(rows),
            "The rank of each reading in its forecast; a no-echo ranks above all ranges. "
                + "Right forecasts give the dashed line. A heap at 1 means that echoes did not "
                + "come, or came too late."));
    ResidualGraph.ranges(rows)
        .ifPresent(
            drawing ->
                pictures.add(
                    new PagePicture(
                        "Ranges",
                        drawing,
                        "Range of each echo minus the median that was expected. A shift means wrong "
                            + "ranges. A second heap means another way of the sound, or another object.")));
    page.pictures(pictures);
  }

  private void effects() {
    page.section("Fitted values");
    new Tables(page).parameters(diagnosis);
    if (diagnosis.calibration().size() > 0) {
      page.say(
          data.reference().isEmpty()
              ? "Before the fit, the set-up was given what the scene says beside the sensor (its law"
                  + " of hearing, how well poses are known): "
              : "Before the fit, the set-up was calibrated on the reference readings: ",
          diagnosis.calibration().forms().size(),
          diagnosis.calibration().forms().size() == 1 ? " form, in " : " forms, in ",
          DiagnosisJson.FILE,
          ".");
    }
    diagnosis.setupError().ifPresent(this::setupError);
    page.section("Effects that these data could not show");
    new Tables(page).undetectable(diagnosis.undetectable());
  }

  private void setupError(SetupError error) {
    page.say(
        "The sensor is taken to hear by the ",
        diagnosis.model().word(),
        " law. On reference readings that were not used for its fit it is ",
        Numbers.number(error.gapCm()),
        " cm off; it expects ",
        Numbers.number(error.expectedCm()),
        " cm. Blocks of these readings vary more than chance; evidence is reduced "
            + "accordingly.");
  }

  private void next() {
    page.section("What to measure next");
    if (diagnosis.nextExperiment().isEmpty()) {
      page.say("There is no tie: no further measurement is needed to tell effects apart.");
      return;
    }
    NextExperiment next = diagnosis.nextExperiment().get();
    page.say(
        "To tell ",
        Names.list(next.separates()),
        " apart, measure at the ",
        next.poses().size(),
        " poses of ",
        Html.code(DiagnosisJson.POSES),
        " in this page's folder. They are expected to bring ",
        Numbers.number(next.expectedLogOdds()),
        " nats of evidence (a factor of 2.7 each), whichever effect is true.");
    page.pictures(
        List.of(
            new PagePicture(
                "Poses to measure at",
                PosePlan.of(next.poses(), data.setup().scene()),
                "Seen from above. Each dot is a ping; its line shows where the sensor looks.")));
  }

  private void tried() {
    page.section("Sets of effects that were tried");
    new Tables(page).tried(diagnosis.tried());
    int effects = Definitions.effects().size();
    int all = effects * (effects - 1) / 2;
    long pairs = diagnosis.tried().stream().filter(one -> one.effects().size() == 2).count();
    page.soft(
        diagnosis.tried().size(),
        " sets of effects were scored on rows that were not used for their fit (",
        pairs,
        " of ",
        all,
        " pairs). A score is the evidence against the simulator as it is. The best "
            + "sets are listed here; all are in ",
        DiagnosisJson.FILE,
        ". Other sets were ruled out earlier, because their fits were worse.");
  }

  private void origin(DiagnosisProvenance provenance) {
    page.section("Files and program");
    List<Html> items = new ArrayList<>();
    items.add(Html.of("program ", provenance.version(), ", seed ", provenance.seed()));
    String reference =
        data.reference().isEmpty()
            ? "no reference"
            : data.reference().size() + " reference readings";
    items.add(Html.of(data.readings().size(), " readings, ", reference));
    provenance
        .sha256()
        .forEach((name, hash) -> items.add(Html.of(name, ", SHA-256 ", Html.code(hash))));
    page.list(items);
    page.soft(
        "A gap is twice the mean pinball loss of 19 predicted quantiles of the reading "
            + "(the continuous ranked probability score by quantiles). A no-echo counts as ",
        Numbers.number(data.setup().noEchoM()),
        "\u00a0m.");
  }
}
