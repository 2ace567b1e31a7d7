package simbad.figures.report;

import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import simbad.experiments.run.DetectionMap;
import simbad.experiments.run.ErrorParts;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.TraceMove;
import simbad.figures.page.Html;
import simbad.figures.page.Keys;
import simbad.figures.page.Numbers;
import simbad.figures.page.Page;
import simbad.figures.page.PagePicture;
import simbad.figures.page.Table;
import simbad.figures.plot.SeriesRole;
import simbad.obstacles.ObstacleType;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.DetectionShadow;
import simbad.sonar.shape.ThresholdTable;

/** What a page says and shows of the runs round one obstacle. */
final class ObstacleSection {
  private static final double WORTH_SAYING = 0.01;
  private static final double CM = 100;
  private static final String NOTHING = "\u2013";

  private final Page page;
  private final List<RunResult> results;
  private final ObstacleType type;
  private final SonarSpec sonar;
  private final String id;
  private final int most;

  /**
   * Begins the section.
   *
   * @param page to which it is added
   * @param results of one obstacle; at least one
   * @param sonar the sensor's figures
   * @param id of its table in the page
   * @param most how many corners a curve of it may have
   */
  ObstacleSection(Page page, List<RunResult> results, SonarSpec sonar, String id, int most) {
    this.sonar = sonar;
    this.page = page;
    this.results = results;
    this.type = results.get(0).type();
    this.id = id;
    this.most = most;
  }

  /**
   * Adds the section.
   *
   * @param withMaps whether with the maps
   * @param withTraces whether with the other pictures and their table
   */
  void add(boolean withMaps, boolean withTraces) {
    say();
    List<PagePicture> pictures = new ArrayList<>();
    if (withTraces) {
      pictures.add(traces());
      pictures.add(errors());
      boolean isHeard = type.thresholds().table().greatestM() > 0;
      if (isHeard && results.stream().anyMatch(ObstacleSection::isByLevel)) {
        pictures.add(hearing());
      }
    }
    if (withMaps) {
      results.forEach(result -> pictures.add(map(result)));
    }
    if (!pictures.isEmpty()) {
      page.pictures(pictures);
    }
    files();
  }

  private void say() {
    page.section(type.name());
    page.say(
        "Table ",
        type.thresholds().provenanceWord(),
        type.thresholds().header("source").map(text -> ": " + text).orElse(""),
        ".");
    results.stream().filter(result -> !result.trace().isClosed()).forEach(this::sayLost);
    results.forEach(this::sayMissed);
    TraceMove.of(results).forEach(move -> page.note(move.sentence()));
    ErrorParts.of(results).forEach(parts -> page.note(parts.sentence()));
    results.forEach(this::sayIdle);
  }

  private void sayLost(RunResult result) {
    page.note(
        "With the ",
        result.sensor().word(),
        " sensor the robot did not complete its round: ",
        result.errors().unreachedBearings(),
        " of ",
        result.errors().radialM().size(),
        " bearings were never reached. Its errors are those of the other bearings.");
  }

  /** Thin rays pass a post between them; a sensor of short range does not hear far places. */
  private void sayMissed(RunResult result) {
    double missed = result.map().missedShare(new DetectionShadow(type.thresholds().table()));
    if (missed >= WORTH_SAYING) {
      page.note(
          "The ",
          result.sensor().word(),
          " sensor missed the obstacle at ",
          Numbers.percent(missed, 1),
          " of the map's places and headings at which the table says that it is heard.");
    }
  }

  /** What was found of one obstacle holds for those of its name only. */
  private void sayIdle(RunResult result) {
    List<FittedForm> idle = result.idleForms();
    if (!idle.isEmpty()) {
      page.note(
          "In the model of the ",
          result.sensor().word(),
          " sensor, ",
          idle.stream().map(one -> one.form().toString()).collect(joining(", ")),
          " belongs to an obstacle that is not in this world, so it changes nothing here.");
    }
  }

  private PagePicture traces() {
    Html words =
        Html.of(
            "Seen from above. A sensor that hears what the table says drives along the table's edge.",
            keys().html());
    return new PagePicture(
        "Where the robot drove", TraceView.of(results, id, most), words, Html.NONE);
  }

  private static boolean isByLevel(RunResult result) {
    return SensorRoles.of(result.sensor()) == SeriesRole.LEVEL;
  }

  private PagePicture hearing() {
    Keys keys = new Keys().line("table", "threshold rule").line("level", "level law");
    Html words =
        Html.of(
            "From bearing ",
            Numbers.number(HearingGraph.bestBearingDeg(type, sonar)),
            " degrees, where it is heard farthest. Above: how far off the axis, from three"
                + " distances. Middle: how soft its edge is. Below: by how much a weak echo reads"
                + " beyond the nearest point.",
            keys.html());
    return new PagePicture(
        "What the level law changes", HearingGraph.of(type, sonar), words, Html.NONE);
  }

  private Keys keys() {
    Keys keys = new Keys().line("table", "threshold table");
    results.forEach(
        result -> keys.line(SensorStyle.of(result), result.sensor().word() + " sensor"));
    return keys;
  }

  private PagePicture errors() {
    Keys keys = keys().area("lobe", "what the table hears");
    if (results.stream().anyMatch(ErrorGraph::isCut)) {
      keys.area("cut", "a part of the edge that was not kept");
    }
    Html words =
        Html.of(
            "Above: the table's lobes and the robots' ways. Where a way is below a lobe, "
                + "the robot cut the lobe off. ",
            errorCaption(),
            keys.html());
    return new PagePicture(
            "Lobes and errors by bearing", ErrorGraph.of(results, id, most), words, Html.NONE)
        .with("Both by bearing, as a table", table());
  }

  /** Says of the picture only what is on it. */
  private String errorCaption() {
    return "Below: the radial error by bearing"
        + (RunPictures.errorPlot(results).isLogarithmic() ? ", logarithmic" : "")
        + ". Where the edge runs nearly along a bearing, a small distance from the edge is a large"
        + " radial error.";
  }

  private Table table() {
    List<String> columns = new ArrayList<>(List.of("#bearing, degrees", "#threshold, cm"));
    results.forEach(result -> columns.add("#" + result.sensor().word() + " error, cm"));
    Table table = Table.of(columns).named(id);
    ThresholdTable thresholds = type.thresholds().table();
    for (int i = 0; i < thresholds.size(); i++) {
      List<Object> cells = new ArrayList<>();
      cells.add(Numbers.number(Math.toDegrees(thresholds.bearingRad(i))));
      cells.add(Numbers.fixed(CM * thresholds.valueM(i), 1));
      for (RunResult result : results) {
        OptionalDouble error = result.errors().radialM().get(i);
        cells.add(error.isPresent() ? Numbers.fixed(CM * error.getAsDouble(), 2) : NOTHING);
      }
      table.row(cells.toArray());
    }
    return table;
  }

  private static PagePicture map(RunResult result) {
    return new PagePicture(
        "Where the " + result.sensor().word() + " belt disagrees",
        DisagreementView.of(result),
        "The number of headings, out of "
            + DetectionMap.HEADINGS
            + " random ones, at which the belt and the table disagree; 0 means that they "
            + "agree everywhere. A sensor nearer than its smallest range hears nothing.");
  }

  private void files() {
    List<Object> parts = new ArrayList<>(List.of("Pictures for print, beside this page: "));
    List<String> names = new ArrayList<>(List.of("polar", "errors"));
    results.forEach(result -> names.add("map-" + result.sensor().word()));
    for (String name : names) {
      parts.add(Html.link(type.name() + "/" + name + ".svg", name + ".svg"));
      parts.add(name.equals(names.get(names.size() - 1)) ? "." : ", ");
    }
    page.soft(parts.toArray());
  }
}
