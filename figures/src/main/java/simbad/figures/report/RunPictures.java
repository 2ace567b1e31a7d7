package simbad.figures.report;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.experiments.report.TableName;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.Trace;
import simbad.figures.plot.BearingError;
import simbad.figures.plot.Caption;
import simbad.figures.plot.ErrorPlot;
import simbad.figures.plot.ErrorSeries;
import simbad.figures.plot.MapPlot;
import simbad.figures.plot.PlotFigure;
import simbad.figures.plot.PolarPlot;
import simbad.figures.plot.PolarPoint;
import simbad.figures.plot.PolarSeries;
import simbad.figures.plot.SeriesRole;
import simbad.figures.plot.SeriesStyle;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.WholeFile;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.ThresholdBand;
import simbad.sonar.shape.ThresholdTable;

/** The pictures of one obstacle's runs. */
final class RunPictures {
  private static final int SCREEN_DPI = 150;
  private static final int LONGEST_CAPTION = 96;

  private RunPictures() {}

  /** Writes all pictures of one obstacle into its folder. */
  static void write(Path folder, List<RunResult> results) throws IOException {
    ObstacleType type = results.get(0).type();
    save(polar(type, results), folder, "polar");
    save(errorPlot(results).figure(), folder, "errors");
    for (RunResult result : results) {
      save(map(result), folder, "map-" + result.sensor().word());
    }
  }

  /** The table alone. */
  static PlotFigure table(ObstacleType type) {
    Caption caption = new Caption("Detection thresholds: " + type.name(), provenance(type));
    return new PolarPlot(caption, tableAndBand(type), outline(type)).figure();
  }

  /** One table over another, and how far the other is uncertain. */
  static PlotFigure tables(ObstacleType first, ObstacleType second) {
    Caption caption =
        new Caption(
            "Detection thresholds: " + first.name() + " and " + second.name(),
            first.name() + ", " + provenance(first));
    PolarSeries under =
        new PolarSeries(
            TableName.of(second),
            SeriesRole.OTHER,
            SeriesStyle.CLOSED_LINE,
            points(second.thresholds().table()));
    PolarSeries over = tableSeries(first, first.name());
    List<PolarSeries> series = new ArrayList<>(List.of(over, under));
    band(second.thresholds(), " of " + second.name()).ifPresent(series::add);
    return new PolarPlot(caption, series, outline(first)).figure();
  }

  /** The table and one trace. */
  static PlotFigure table(ObstacleType type, String name, Trace trace) {
    Caption caption = new Caption("Trace round the obstacle: " + type.name(), provenance(type));
    PolarSeries way = new PolarSeries(name, SeriesRole.OTHER, SeriesStyle.LINE, places(trace));
    List<PolarSeries> series = tableAndBand(type);
    series.add(way);
    return new PolarPlot(caption, series, outline(type)).figure();
  }

  private static void save(PlotFigure figure, Path folder, String name) throws IOException {
    WholeFile.write(folder.resolve(name + ".png"), figure.png(SCREEN_DPI));
    WholeFile.write(folder.resolve(name + ".svg"), figure.svg());
  }

  private static PlotFigure polar(ObstacleType type, List<RunResult> results) {
    List<PolarSeries> series = new ArrayList<>();
    series.add(tableSeries(type));
    for (RunResult result : results) {
      series.add(
          new PolarSeries(
              "trace, " + result.sensor().word() + " sensor",
              SensorRoles.of(result.sensor()),
              SeriesStyle.LINE,
              SensorRoles.pattern(result.sensor()),
              places(result.trace())));
    }
    return new PolarPlot(
            new Caption("Edge followed round the obstacle: " + type.name(), provenance(type)),
            series,
            outline(type))
        .figure();
  }

  /** The radial errors of all sensors round one obstacle. */
  static ErrorPlot errorPlot(List<RunResult> results) {
    List<ErrorSeries> series = new ArrayList<>();
    for (RunResult result : results) {
      series.add(
          new ErrorSeries(
              result.sensor().word() + " sensor",
              SensorRoles.of(result.sensor()),
              SensorRoles.pattern(result.sensor()),
              bearingErrors(result)));
    }
    ObstacleType type = results.get(0).type();
    return new ErrorPlot(
        new Caption("Radial error of the traces: " + type.name(), provenance(type)),
        series,
        points(type.thresholds().table()));
  }

  private static List<BearingError> bearingErrors(RunResult result) {
    ThresholdTable table = result.type().thresholds().table();
    List<BearingError> errors = new ArrayList<>();
    for (int i = 0; i < table.size(); i++) {
      OptionalDouble error = result.errors().radialM().get(i);
      if (error.isPresent()) {
        errors.add(new BearingError(table.bearingRad(i), error.getAsDouble()));
      }
    }
    return errors;
  }

  private static PlotFigure map(RunResult result) {
    ObstacleType type = result.type();
    return new MapPlot(
            new Caption(
                "Where the " + result.sensor().word() + " sensor disagrees: " + type.name(),
                provenance(type)),
            "share of headings at which belt and table disagree",
            result.map().disagreement(),
            List.of(tableSeries(type)),
            outline(type))
        .figure();
  }

  private static PolarSeries tableSeries(ObstacleType type) {
    return tableSeries(type, "threshold table");
  }

  private static PolarSeries tableSeries(ObstacleType type, String name) {
    return new PolarSeries(
        TableName.of(name, type.thresholds()),
        SeriesRole.TABLE,
        SeriesStyle.CLOSED_LINE,
        points(type.thresholds().table()));
  }

  private static List<PolarSeries> tableAndBand(ObstacleType type) {
    List<PolarSeries> series = new ArrayList<>(List.of(tableSeries(type)));
    band(type.thresholds(), "").ifPresent(series::add);
    return series;
  }

  /** Of the header's line the legend takes the words behind the columns' names. */
  private static Optional<PolarSeries> band(TableDocument document, String of) {
    String meaning =
        document
            .header("band")
            .filter(text -> text.contains(","))
            .map(text -> text.substring(text.indexOf(',')))
            .orElse("");
    return document
        .band()
        .map(
            band ->
                new PolarSeries(
                    "uncertainty" + of + meaning, SeriesRole.BAND, SeriesStyle.AREA, ring(band)));
  }

  /** Round the upper ends, and back round the lower ones. */
  private static List<PolarPoint> ring(ThresholdBand band) {
    List<PolarPoint> ring = points(band.high());
    ring.add(ring.get(0));
    List<PolarPoint> hole = points(band.low());
    hole.add(hole.get(0));
    Collections.reverse(hole);
    ring.addAll(hole);
    return ring;
  }

  private static List<PolarPoint> points(ThresholdTable table) {
    List<PolarPoint> points = new ArrayList<>();
    for (int i = 0; i < table.size(); i++) {
      points.add(new PolarPoint(table.bearingRad(i), table.valueM(i)));
    }
    return points;
  }

  private static List<PolarPoint> places(Trace trace) {
    List<PolarPoint> places = new ArrayList<>();
    for (int i = trace.firstOnEdge(); i < trace.size(); i++) {
      places.add(PolarPoint.ofOffset(trace.xM(i), trace.zM(i)));
    }
    return places;
  }

  private static List<PolarPoint> outline(ObstacleType type) {
    return type.outline().corners().stream().map(RunPictures::point).toList();
  }

  private static PolarPoint point(Point corner) {
    return PolarPoint.ofOffset(corner.xM(), corner.zM());
  }

  /** The first clause of the source is enough on a picture; the page has all of it. */
  static String provenance(ObstacleType type) {
    String source =
        type.thresholds().header("source").map(text -> ": " + text.split(";", 2)[0]).orElse("");
    String whole = "table " + type.thresholds().provenanceWord() + source;
    return whole.length() <= LONGEST_CAPTION
        ? whole
        : whole.substring(0, LONGEST_CAPTION - 1).stripTrailing() + "…";
  }
}
