package simbad.experiments.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Line2D;
import java.util.List;
import java.util.Objects;
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
