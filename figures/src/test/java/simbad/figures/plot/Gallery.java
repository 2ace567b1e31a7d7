package simbad.figures.plot;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.experiments.run.ShareGrid;

/**
 * Pictures to be looked at, as no test can: {@code Gallery DIR} writes them as PNG and SVG. The
 * tests run over the same figures.
 */
final class Gallery {
  private static final int SCREEN_DPI = 144;

  private Gallery() {}

  public static void main(String[] args) throws IOException {
    Path folder = Files.createDirectories(Path.of(args[0]));
    for (Map.Entry<String, PlotFigure> entry : figures().entrySet()) {
      Files.write(folder.resolve(entry.getKey() + ".png"), entry.getValue().png(SCREEN_DPI));
      Files.write(folder.resolve(entry.getKey() + ".svg"), entry.getValue().svg());
    }
  }

  static Map<String, PlotFigure> figures() {
    Map<String, PlotFigure> figures = new LinkedHashMap<>();
    figures.put("main", polar(PlotSamples.tableSeries(), PlotSamples.originalSeries(), shadow()));
    figures.put("table", polar(PlotSamples.tableSeries()));
    figures.put("roles", polar(roles()));
    figures.put("empty", polar());
    figures.put("large", polar(scaled("table of a large target", 6.3)));
    figures.put("long-names", polar(longNames()));
    figures.put("errors", errors().figure());
    figures.put("errors-linear", linearErrors().figure());
    figures.put("map", map().figure());
    return figures;
  }

  private static PolarSeries shadow() {
    return PlotSamples.shadowSeries();
  }

  private static PlotFigure polar(PolarSeries... series) {
    return new PolarPlot(PlotSamples.CAPTION, List.of(series), PlotSamples.OUTLINE).figure();
  }

  private static PolarSeries[] roles() {
    List<SeriesRole> roles = List.of(SeriesRole.values());
    return roles.stream()
        .map(r -> new PolarSeries(r.name(), r, SeriesStyle.LINE, circle(roles.indexOf(r))))
        .toArray(PolarSeries[]::new);
  }

  private static List<PolarPoint> circle(int index) {
    return PlotSamples.circle(1 + 0.2 * index, 700);
  }

  private static PolarSeries scaled(String name, double factor) {
    List<PolarPoint> points =
        PlotSamples.angleTable().stream()
            .map(p -> new PolarPoint(p.bearingRad(), p.radiusM() * factor))
            .toList();
    return new PolarSeries(name, SeriesRole.TABLE, SeriesStyle.CLOSED_LINE, points);
  }

  private static PolarSeries[] longNames() {
    return new PolarSeries[] {
      new PolarSeries(
          "threshold table of the 25 mm angle extrusion as the thesis lists it vertex by vertex,"
              + " one sweep, steps of 2 cm along the bench and 5 degrees of turn",
          SeriesRole.TABLE,
          SeriesStyle.CLOSED_LINE,
          PlotSamples.angleTable()),
      new PolarSeries(
          "readings", SeriesRole.NOISY, SeriesStyle.POINTS, PlotSamples.circle(1.7, 90)),
      new PolarSeries("nothing came of this one", SeriesRole.RAY, SeriesStyle.LINE, List.of())
    };
  }

  static ErrorPlot errors() {
    List<PolarPoint> table = PlotSamples.angleTable();
    return new ErrorPlot(
        PlotSamples.CAPTION,
        List.of(
            new ErrorSeries(
                "original sensor",
                SeriesRole.ORIGINAL,
                PlotSamples.errors(deg -> Math.abs(2.5 - table.get(deg / 5).radiusM()))),
            new ErrorSeries(
                "shadow sensor",
                SeriesRole.SHADOW,
                PlotSamples.errors(deg -> deg == 45 ? 0 : 0.003 + 0.02 * Math.pow(Math.sin(deg), 2))
                    .stream()
                    .filter(e -> e.bearingDeg() < 200 || e.bearingDeg() > 220)
                    .toList())));
  }

  private static ErrorPlot linearErrors() {
    return new ErrorPlot(
        new Caption("Square extrusion, 25 mm", "table: reconstructed, not measured"),
        List.of(
            new ErrorSeries(
                "noisy sensor",
                SeriesRole.NOISY,
                PlotSamples.errors(deg -> 0.05 + 0.02 * Math.cos(Math.toRadians(4 * deg))))));
  }

  static MapPlot map() {
    return new MapPlot(
        new Caption("Angle extrusion, 25 mm: original sensor", "table: measured"),
        "share of headings that disagree with the table",
        ShareGrid.of(120, 3.5, Gallery::share),
        List.of(PlotSamples.tableSeries()),
        PlotSamples.OUTLINE);
  }

  private static double share(double xM, double zM) {
    double r = Math.hypot(xM, zM);
    double within = 1 / (1 + Math.exp((r - 2.5) / 0.08));
    return within * (0.5 - 0.5 * Math.cos(2 * Math.atan2(xM, zM)));
  }
}
