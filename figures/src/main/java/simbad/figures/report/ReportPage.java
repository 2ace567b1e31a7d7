package simbad.figures.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import simbad.experiments.control.Tuning;
import simbad.experiments.report.ErrorRecord;
import simbad.experiments.report.ErrorWords;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.report.TableName;
import simbad.experiments.run.EdgeLoss;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.SensorKind;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Page;
import simbad.figures.page.Table;
import simbad.sonar.format.TextFile;
import simbad.sonar.scene.SonarSpec;

/** A run's page: what was asked, the figures, the pictures, and how to read each. */
final class ReportPage {
  /** What a page may have. */
  private static final int MOST_CHARACTERS = 295_000;

  private static final int MOST_CORNERS = 2_000;

  /** From fine to coarse: the first with which a page is small enough is taken. */
  private static final List<Detail> DETAILS =
      List.of(
          new Detail(20_000, true),
          new Detail(8_000, true),
          new Detail(8_000, false),
          new Detail(0, false));

  /**
   * How much is drawn.
   *
   * @param corners that all curves of a page may have together, in some 6 bytes each; 0 for no
   *     pictures, which stand beside the page
   * @param maps whether the maps stand on the page, or only beside it
   */
  private record Detail(int corners, boolean maps) {
    /** Of each drive there are two curves. */
    int each(int drives) {
      return Math.min(MOST_CORNERS, corners / Math.max(1, 2 * drives));
    }
  }

  private static final String NOTHING = "\u2013";

  private final Page page;
  private final List<RunResult> results;

  private ReportPage(PageTop top, Collection<List<RunResult>> byObstacle) {
    page = new Page(top.title(), top.title());
    top.first().accept(page);
    results = byObstacle.stream().flatMap(List::stream).toList();
  }

  static void write(
      Path file,
      PageTop top,
      RunOrigin origin,
      Map<String, String> hashes,
      Map<String, List<RunResult>> byObstacle)
      throws IOException {
    String html = "";
    for (Detail detail : DETAILS) {
      html = new ReportPage(top, byObstacle.values()).html(origin, hashes, byObstacle, detail);
      if (html.length() <= MOST_CHARACTERS) {
        break;
      }
    }
    TextFile.write(file, html);
  }

  private String html(
      RunOrigin origin,
      Map<String, String> hashes,
      Map<String, List<RunResult>> byObstacle,
      Detail detail) {
    addLimits();
    addErrors();
    int number = 0;
    for (List<RunResult> one : byObstacle.values()) {
      ObstacleSection section =
          new ObstacleSection(
              page,
              one,
              origin.settings().sonar(),
              "bearings-" + ++number,
              detail.each(results.size()));
      section.add(detail.maps(), detail.corners() > 0);
    }
    addOrigin(origin, hashes);
    return page.html();
  }

  private void addLimits() {
    page.note(
        "No robot was ever traced round these obstacles in reality. The traces show what follows from"
            + " a threshold table; they do not test the table. The measured table has steps of"
            + " 2\u00a0cm and is a single sweep of one sensor (Kranz 2014). Tables marked"
            + " reconstructed were never published as numbers.");
  }

  private void addErrors() {
    boolean isCompared = hasReduction();
    List<String> columns =
        new ArrayList<>(
            List.of(
                "obstacle (table)",
                "sensor",
                "#" + ErrorWords.MEAN,
                "#" + ErrorWords.RMS,
                "#median cm",
                "#" + ErrorWords.MAX,
                "#" + ErrorWords.BESIDE,
                "#beside 95\u00a0% cm",
                "#" + ErrorWords.EDGE_KEPT,
                "#" + ErrorWords.FROM_EDGE,
                "#" + ErrorWords.UNREACHED));
    if (isCompared) {
      columns.add("#" + ErrorWords.REDUCTION);
    }
    columns.add("#map agrees");
    Table table = Table.of(columns);
    results.forEach(result -> table.row(row(result, isCompared)));
    page.section("Errors against the tables").table(table);
    addMeanings(isCompared);
    EdgeLoss.of(results).forEach(loss -> page.note(loss.sentence()));
  }

  private void addMeanings(boolean isCompared) {
    int lines = ErrorWords.MEANINGS.size() - (isCompared ? 0 : 1);
    page.soft(
        String.join(" ", ErrorWords.MEANINGS.subList(0, lines)).replaceAll(";$", "."),
        " The radial error of a bearing is the mean over all crossings of that "
            + "bearing. It is large where the edge runs nearly along the bearing, even if "
            + "the robot is near the edge. If the robot cut off a lobe, less of the edge is "
            + "kept and the distance from the edge is large. Map agrees: the share of places "
            + "and headings at which belt and table agree whether the obstacle is heard.");
    page.soft(
        "In errors.csv and errors.json the columns of figures are called "
            + "mean_abs_cm, rms_cm, median_abs_cm, max_abs_cm, lateral_mean_cm, lateral_p95_cm, "
            + "edge_kept, edge_to_trace_max_cm, unreached_bearings, "
            + (isCompared ? "reduction_vs_original, " : "")
            + "map_agreement, in this order.");
  }

  /** Without an original sensor there is nothing to be smaller than. */
  private boolean hasReduction() {
    return results.stream()
        .filter(result -> !result.sensor().equals(SensorKind.ORIGINAL))
        .anyMatch(result -> result.reductionVsOriginal().isPresent());
  }

  private static Object[] row(RunResult result, boolean isCompared) {
    ErrorRecord row = ErrorRecord.of(result);
    List<Object> cells = new ArrayList<>();
    cells.add(TableName.of(result.type()));
    cells.add(row.sensor());
    cells.add(number(row.meanAbsCm()));
    cells.add(number(row.rmsCm()));
    cells.add(number(row.medianAbsCm()));
    cells.add(number(row.maxAbsCm()));
    cells.add(number(row.lateralMeanCm()));
    cells.add(number(row.lateralP95Cm()));
    cells.add(percent(row.edgeKept(), 1));
    cells.add(number(row.edgeToTraceMaxCm()));
    cells.add(row.unreachedBearings() + "/" + row.bearings());
    if (isCompared) {
      cells.add(percent(row.reductionVsOriginal(), 1));
    }
    cells.add(percent(OptionalDouble.of(row.mapAgreement()), 2));
    return cells.toArray();
  }

  private static String number(OptionalDouble value) {
    return value.isPresent() ? Numbers.fixed(value.getAsDouble(), 2) : NOTHING;
  }

  private static String percent(OptionalDouble share, int decimals) {
    return share.isPresent() ? Numbers.percent(share.getAsDouble(), decimals) : NOTHING;
  }

  private void addOrigin(RunOrigin origin, Map<String, String> hashes) {
    List<Html> items = new ArrayList<>();
    items.add(Html.of("program ", origin.version()));
    items.add(Html.of("seed ", origin.settings().seed()));
    if (origin.settings().pace().turnRateRadPerS() < Tuning.TURN_RATE) {
      items.add(
          Html.of(
              "the robot is told to turn at ",
              origin.settings().pace().turnRateRadPerS(),
              " rad/s at most; a faster turn becomes a longer one on the spot"));
    }
    if (origin.settings().pace().waitS() > 0) {
      items.add(
          Html.of(
              "the robot stands still for ",
              origin.settings().pace().waitS(),
              " s after each step"));
    }
    items.add(robot(origin));
    items.add(sonar(origin.settings().sonar()));
    for (SensorKind kind : origin.settings().sensors()) {
      items.add(Html.of(kind.word(), " sensor: ", kind.meaning()));
    }
    hashes.forEach(
        (name, hash) -> items.add(Html.of(name, "/table.csv, SHA-256 ", Html.code(hash))));
    page.section("Settings and files").list(items);
  }

  private static Html robot(RunOrigin origin) {
    return Html.of(
        "robot: ",
        SensorKind.SONARS,
        " sonars at its centre, all round; ",
        origin.settings().speedMPerS(),
        " m/s, in curves at most ",
        Tuning.BEND_SPEED_M_PER_S,
        " m/s, steps of 0.05 s; a slower robot stays nearer to the edge");
  }

  private static Html sonar(SonarSpec sonar) {
    return Html.of(
        "sonar ",
        sonar.name(),
        ": cone half-angle ",
        Numbers.fixed(Math.toDegrees(sonar.coneHalfAngleRad()), 1),
        "°, range ",
        sonar.minRangeM(),
        " to ",
        sonar.maxRangeM(),
        " m");
  }
}
