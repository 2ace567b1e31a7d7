package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;

class PolarPlotTest {
  private static final int SVG_LIMIT = 500_000;

  @Test
  void chart_holdsTheTableCornerByCorner() {
    XYSeries table = series(figure(PlotSamples.tableSeries()), "threshold table");
    assertEquals(73, table.getXData().length);
    checkPoint(table, 0, 0, -3.16);
    // 90 degrees, 2.7 m: to the right.
    checkPoint(table, 18, 2.7, 0);
    // 180 degrees, 2.88 m: up the page.
    checkPoint(table, 36, 0, 2.88);
    checkPoint(table, 72, 0, -3.16);
  }

  private static void checkPoint(XYSeries series, int index, double x, double y) {
    assertEquals(x, series.getXData()[index], 1e-9);
    assertEquals(y, series.getYData()[index], 1e-9);
  }

  @Test
  void bearings_runFromTheBottomToTheRight() {
    XYChart chart = figure(PlotSamples.tableSeries()).chart();
    double centreX = chart.getScreenXFromChart(0);
    double centreY = chart.getScreenYFromChart(0);
    PolarPoint ahead = PlotSamples.point(0, 1);
    PolarPoint right = PlotSamples.point(90, 1);
    assertTrue(chart.getScreenYFromChart(-ahead.zM()) > centreY);
    assertTrue(chart.getScreenXFromChart(right.xM()) > centreX);
  }

  @Test
  void labels_nameAxesUnitsAndSeries() {
    XYChart chart = mainFigure().chart();
    assertEquals("x (m), seen from above", chart.getXAxisTitle());
    assertEquals("z (m), down the page", chart.getYAxisTitle());
    assertEquals(PlotSamples.CAPTION.title(), chart.getTitle());
    assertEquals(
        List.of("threshold table", "trace, original sensor", "trace, shadow sensor", "obstacle"),
        chart.getSeriesMap().values().stream().map(XYSeries::getLabel).toList());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.07, 1, 3.16, 20})
  void aspect_isSquareInTheLayout(double radiusM) {
    PlotFigure figure = figure(circle("c", radiusM));
    assertEquals(1, aspect(figure.chart(), radiusM), 1e-6);
    figure.svg();
    assertEquals(1, aspect(figure.chart(), radiusM), 1e-3);
    figure.png(300);
    assertEquals(1, aspect(figure.chart(), radiusM), 1e-3);
  }

  private static double aspect(XYChart chart, double lengthM) {
    double across = chart.getScreenXFromChart(lengthM) - chart.getScreenXFromChart(0);
    double down = chart.getScreenYFromChart(0) - chart.getScreenYFromChart(lengthM);
    return across / down;
  }

  @Test
  void aspect_isSquareInThePixels() throws IOException {
    int[] box = blackBox(figure(circle("circle", 2.3)).png(200));
    assertEquals(box[1] - box[0], box[3] - box[2], 1);
    assertTrue(box[1] - box[0] > 500, "the circle was found");
  }

  /** The bounds of what is black: only a table is. */
  private static int[] blackBox(byte[] png) throws IOException {
    var image = ImageIO.read(new ByteArrayInputStream(png));
    int[] box = {Integer.MAX_VALUE, 0, Integer.MAX_VALUE, 0};
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        // The legend's key is black as well, below the plot.
        if ((image.getRGB(x, y) & 0xFFFFFF) == 0 && y < image.getWidth()) {
          box =
              new int[] {
                Math.min(box[0], x), Math.max(box[1], x), Math.min(box[2], y), Math.max(box[3], y)
              };
        }
      }
    }
    return box;
  }

  @Test
  void everything_liesWithinThePlot() {
    XYChart chart = figure(circle("table", 20)).chart();
    assertTrue(chart.getStyler().getXAxisMax() > 20);
    assertTrue(chart.getStyler().getYAxisMin() < -20);
  }

  @ParameterizedTest
  @EnumSource(SeriesStyle.class)
  void emptySeries_isDrawnAndSaid(SeriesStyle style) {
    PlotFigure figure = figure(new PolarSeries("nothing", SeriesRole.RAY, style, List.of()));
    assertEquals("nothing (no points)", series(figure, "nothing").getLabel());
    checkDrawn(figure);
  }

  @ParameterizedTest
  @EnumSource(SeriesStyle.class)
  void onePoint_isDrawn(SeriesStyle style) {
    checkDrawn(
        figure(
            new PolarSeries("one", SeriesRole.NOISY, style, List.of(PlotSamples.point(30, 1.5)))));
  }

  @Test
  void thresholdsOfZero_areDrawn() {
    checkDrawn(figure(circle("zero", 0)));
  }

  @Test
  void noSeries_stillShowsTheGrid() {
    checkDrawn(new PolarPlot(PlotSamples.CAPTION, List.of(), List.of()).figure());
  }

  private static void checkDrawn(PlotFigure figure) {
    assertTrue(figure.png(72).length > 1000);
    assertTrue(figure.svg().length > 1000);
  }

  @Test
  void longNames_areBrokenAndTheFigureGrows() {
    String name = "a name that goes on ".repeat(20).strip();
    PlotFigure figure = figure(circle(name, 1));
    assertTrue(series(figure, name).getLabel().contains("\n"));
    assertEquals(name, series(figure, name).getLabel().replace('\n', ' '));
    assertTrue(figure.heightPt() > figure(circle("short", 1)).heightPt());
  }

  @Test
  void longTraces_areThinnedAndTheSvgStaysSmall() {
    PlotFigure figure = mainFigure();
    assertTrue(series(figure, "trace, shadow sensor").getXData().length < 20_000);
    assertTrue(figure.svg().length < SVG_LIMIT, () -> figure.svg().length + " bytes");
  }

  @Test
  void fiveLongCloudsAndTraces_stayUnderTheLimit() {
    List<PolarPoint> wobble = PlotSamples.wobbling(PlotSamples.angleTable(), 800);
    PolarSeries[] five =
        Stream.of("a", "b", "c", "d", "e")
            .map(name -> new PolarSeries(name, SeriesRole.OTHER, styleOf(name), wobble))
            .toArray(PolarSeries[]::new);
    int bytes = figure(five).svg().length;
    assertTrue(bytes < SVG_LIMIT, () -> bytes + " bytes");
  }

  private static SeriesStyle styleOf(String name) {
    return name.compareTo("d") < 0 ? SeriesStyle.LINE : SeriesStyle.POINTS;
  }

  @Test
  void sameNameTwice_isRefused() {
    assertThrows(
        IllegalArgumentException.class,
        () ->
            new PolarPlot(PlotSamples.CAPTION, List.of(circle("a", 1), circle("a", 2)), List.of()));
  }

  @Test
  void obstaclesName_isTakenWhereAnOutlineIsDrawn() {
    PolarPlot plot =
        new PolarPlot(PlotSamples.CAPTION, List.of(circle("obstacle", 1)), PlotSamples.OUTLINE);
    assertThrows(IllegalArgumentException.class, plot::figure);
  }

  @Test
  void blankName_isRefused() {
    assertThrows(IllegalArgumentException.class, () -> circle(" ", 1));
  }

  @Test
  void roles_keepTheirColoursInEveryPicture() {
    XYSeries alone = series(figure(PlotSamples.originalSeries()), "trace, original sensor");
    XYSeries amongOthers = series(mainFigure(), "trace, original sensor");
    assertEquals(0xD55E00, alone.getLineColor().getRGB() & 0xFFFFFF);
    assertEquals(alone.getLineColor(), amongOthers.getLineColor());
    assertArrayEquals(
        alone.getLineStyle().getDashArray(), amongOthers.getLineStyle().getDashArray());
  }

  @Test
  void clouds_areDottedInTheLegend() {
    PolarSeries cloud =
        new PolarSeries("cloud", SeriesRole.SHADOW, SeriesStyle.POINTS, PlotSamples.circle(1, 9));
    assertTrue(series(figure(cloud), "cloud").getLineStyle().getDashArray() != null);
    assertEquals(Set.of("cloud"), figure(cloud).chart().getSeriesMap().keySet());
  }

  private static PolarSeries circle(String name, double radiusM) {
    return new PolarSeries(
        name, SeriesRole.TABLE, SeriesStyle.CLOSED_LINE, PlotSamples.circle(radiusM, 720));
  }

  private static PlotFigure mainFigure() {
    return new PolarPlot(
            PlotSamples.CAPTION,
            List.of(
                PlotSamples.tableSeries(),
                PlotSamples.originalSeries(),
                PlotSamples.shadowSeries()),
            PlotSamples.OUTLINE)
        .figure();
  }

  private static PlotFigure figure(PolarSeries... series) {
    return new PolarPlot(PlotSamples.CAPTION, List.of(series), List.of()).figure();
  }

  private static XYSeries series(PlotFigure figure, String name) {
    return PlotSamples.seriesOf(figure, name);
  }
}
