package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Objects;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;

class ErrorPlotTest {
  @Test
  void chart_holdsCentimetresByDegrees() {
    XYSeries series = curve(PlotSamples.errors(deg -> 0.05 + 0.0001 * deg));
    assertEquals(73, series.getXData().length);
    assertEquals(45, series.getXData()[9], 1e-9);
    assertEquals(5.45, series.getYData()[9], 1e-9);
  }

  @Test
  void fullTurn_repeatsTheFirstValue() {
    XYSeries series = curve(PlotSamples.errors(deg -> 0.05 + 0.0001 * deg));
    assertEquals(360, series.getXData()[72]);
    assertEquals(series.getYData()[0], series.getYData()[72]);
  }

  @Test
  void missingBearings_breakTheCurve() {
    XYSeries series =
        curve(
            PlotSamples.errors(deg -> 0.05).stream()
                .filter(e -> e.bearingDeg() < 100 || e.bearingDeg() > 130)
                .toList());
    assertEquals(1, DoubleStream.of(series.getYData()).filter(Double::isNaN).count());
  }

  @Test
  void errors_areSortedByBearing() {
    XYSeries series = curve(List.of(error(350, 0.1), error(-20, 0.1), error(10, 0.1)));
    assertEquals(10, series.getXData()[0], 1e-9);
    assertEquals(340, series.getXData()[2], 1e-9);
  }

  @Test
  void axes_nameUnits() {
    XYChart chart = Gallery.errors().figure().chart();
    assertEquals("bearing in the table (degrees)", chart.getXAxisTitle());
    assertEquals("radial error |r − T| (cm)", chart.getYAxisTitle());
    assertEquals(360, chart.getStyler().getXAxisMax());
    assertTrue(chart.getStyler().isYAxisLogarithmic());
  }

  @Test
  void aFewCentimetres_areLinear() {
    assertFalse(figure(PlotSamples.errors(deg -> 0.05)).chart().getStyler().isYAxisLogarithmic());
  }

  @Test
  void onePoint_emptySeriesAndNoSeries_areDrawn() {
    checkDrawn(figure(List.of(error(90, 0.02))));
    checkDrawn(figure(List.of()));
    checkDrawn(new ErrorPlot(PlotSamples.CAPTION, List.of()).figure());
  }

  @Test
  void zeros_areDrawnAtTheBottomOfALogAxis() {
    List<BearingError> errors = List.of(error(0, 0), error(5, 0.01), error(10, 2));
    assertEquals(1, curve(errors).getYData()[0]);
    checkDrawn(figure(errors));
  }

  private static void checkDrawn(PlotFigure figure) {
    assertTrue(figure.png(72).length > 1000);
    assertTrue(figure.svg().length > 1000);
  }

  @ParameterizedTest
  @CsvSource({
    "0.5, 300, true, 0.5, 500",
    "3, 20, false, 0, 25",
    "0, 0, false, 0, 1",
    "0.000001, 2000, true, 0.01, 5000"
  })
  void scale_holdsTheErrors(double least, double most, boolean isLog, double from, double to) {
    ErrorScale scale = ErrorScale.of(least, most);
    assertEquals(isLog, scale.isLog());
    assertEquals(from, scale.bottomCm(), 1e-12);
    assertEquals(to, scale.topCm(), 1e-9);
    assertTrue(scale.ticks().size() >= 3 && scale.ticks().size() <= 10, scale.ticks()::toString);
  }

  @Test
  void bottomLabel_saysWhenLessIsDrawnThere() {
    assertEquals("≤1", ErrorScale.of(0, 1, 300).label(1));
    assertEquals("1", ErrorScale.of(1, 300).label(1));
    assertEquals("10", ErrorScale.of(0, 1, 300).label(10));
  }

  @Test
  void bearings_areTakenIntoOneTurn() {
    assertEquals(350, error(-10, 1).bearingDeg(), 1e-9);
    assertEquals(0, error(360, 1).bearingDeg());
    assertEquals(5, error(725, 1).bearingDeg(), 1e-9);
  }

  @Test
  void badNumbers_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> error(Double.NaN, 1));
    assertThrows(IllegalArgumentException.class, () -> error(0, Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> error(0, -1));
    assertThrows(IllegalArgumentException.class, () -> error(0, Double.POSITIVE_INFINITY));
  }

  private static BearingError error(double bearingDeg, double errorM) {
    return new BearingError(Math.toRadians(bearingDeg), errorM);
  }

  private static XYSeries curve(List<BearingError> errors) {
    return PlotSamples.seriesOf(figure(errors), "sensor");
  }

  private static PlotFigure figure(List<BearingError> errors) {
    ErrorSeries series = new ErrorSeries("sensor", SeriesRole.SHADOW, errors);
    return new ErrorPlot(PlotSamples.CAPTION, List.of(series)).figure();
  }

  /**
   * The largest lobe fills the plot, the smallest is at its bottom, at 360 degrees it is as at 0.
   */
  @Test
  void lobes_standBehindTheErrors() {
    List<PolarPoint> table =
        List.of(new PolarPoint(0, 0), new PolarPoint(Math.PI / 2, 2), new PolarPoint(Math.PI, 1));
    ErrorSeries errors =
        new ErrorSeries("shadow", SeriesRole.SHADOW, List.of(new BearingError(0, 0.01)));
    XYChart chart =
        new ErrorPlot(new Caption("Title", "table"), List.of(errors), table).figure().chart();
    XYSeries lobes =
        Objects.requireNonNull(chart.getSeriesMap().get("the table's lobes, the largest 2 m"));
    double top = chart.getStyler().getYAxisMax();
    assertArrayEquals(new double[] {0, 90, 180, 360, 360, 0}, lobes.getXData(), 1e-9);
    assertArrayEquals(new double[] {0, 0.94 * top, 0.47 * top, 0, 0, 0}, lobes.getYData(), 1e-9);
  }

  @Test
  void noTable_noLobes() {
    XYChart chart = new ErrorPlot(new Caption("Title", "table"), List.of()).figure().chart();
    assertEquals(0, chart.getSeriesMap().size());
  }
}
