package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BasicStroke;
import java.awt.geom.Line2D;
import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class TuningPlotTest {
  /** The line of a legend. */
  private static final Line2D KEY = new Line2D.Double(0, 0, 38, 0);

  private static TuningPlot plot(double leastCm, double mostCm) {
    TuningPlot.Line line =
        new TuningPlot.Line(
            "shadow",
            SeriesRole.SHADOW,
            List.of(new TuningPlot.Point(1, leastCm), new TuningPlot.Point(60, mostCm)));
    TuningPlot.Line mark =
        new TuningPlot.Line("best", SeriesRole.TABLE, List.of(new TuningPlot.Point(1, leastCm)));
    return new TuningPlot(
        new Caption("title", "2 runs"), "angle (degrees)", List.of(line), List.of(mark));
  }

  @Test
  void figure_wideErrors_areOnALogarithmicAxis() {
    assertTrue(plot(0.3, 100).figure().chart().getStyler().isYAxisLogarithmic());
    assertFalse(plot(10, 100).figure().chart().getStyler().isYAxisLogarithmic());
  }

  private static TuningPlot along(double... parameters) {
    List<TuningPlot.Point> points =
        DoubleStream.of(parameters).mapToObj(it -> new TuningPlot.Point(it, 1)).toList();
    TuningPlot.Line line = new TuningPlot.Line("shadow", SeriesRole.SHADOW, points);
    return new TuningPlot(new Caption("title", "2 runs"), "angle", List.of(line), List.of());
  }

  /** From 0, values from 20 to 40 would fill half of the plot. */
  @Test
  void axis_spansTheValues() {
    assertAxis(along(20, 30, 40), 19.6, 40.4);
    assertAxis(along(1, 60), 0, 61.18);
    assertAxis(along(-4, -2), -4.04, -1.96);
    assertAxis(along(30), 15, 45);
    assertAxis(along(0), 0, 0.01);
  }

  private static void assertAxis(TuningPlot plot, double left, double right) {
    var styler = plot.figure().chart().getStyler();
    assertEquals(left, styler.getXAxisMin(), 1e-9);
    assertEquals(right, styler.getXAxisMax(), 1e-9);
  }

  /** No two of one colour look alike. */
  @Test
  void patterns_differ() {
    Set<BasicStroke> strokes = new HashSet<>();
    for (int pattern = 1; pattern <= TuningPlot.Line.PATTERNS; pattern++) {
      strokes.add(PlotLook.of(SeriesRole.SHADOW).withPattern(pattern).stroke());
    }
    assertEquals(TuningPlot.Line.PATTERNS, strokes.size());
    int tooMany = TuningPlot.Line.PATTERNS + 1;
    assertThrows(
        IllegalArgumentException.class,
        () -> new TuningPlot.Line("one", SeriesRole.SHADOW, tooMany, List.of()));
  }

  @Test
  void figure_listsCurvesAndMarks() {
    var series = plot(1, 2).figure().chart().getSeriesMap();
    assertEquals(List.of("shadow", "best"), List.copyOf(series.keySet()));
    assertArrayEquals(
        new double[] {1, 60}, Objects.requireNonNull(series.get("shadow")).getXData());
  }

  @Test
  void legend_hasOneDotHalfWay() {
    var mark = plot(1, 2).figure().chart().getSeriesMap().get("best");
    var drawn = Objects.requireNonNull(mark).getLineStyle().createStrokedShape(KEY).getBounds2D();
    assertEquals(KEY.getX2() / 2, drawn.getCenterX(), 0.5);
    assertTrue(drawn.getWidth() < KEY.getX2() / 2, drawn.toString());
  }

  @Test
  void figure_twice_hasTheSameBytes() {
    assertArrayEquals(plot(1, 40).figure().svg(), plot(1, 40).figure().svg());
  }

  @Test
  void sameNameTwice_isRefused() {
    TuningPlot one = plot(1, 2);
    assertThrows(
        IllegalArgumentException.class,
        () -> new TuningPlot(one.caption(), "x", one.curves(), one.curves()));
  }
}
