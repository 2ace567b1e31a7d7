package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYSeries;

class AgreementPlotTest {
  private static final AgreementPlot.Axes SHARES =
      new AgreementPlot.Axes("probability stated", "share that was so", 0, 1);

  private static Figure figure(AgreementPoint... points) {
    return new AgreementPlot(new Caption("Title", "L1; n = 3"), SHARES, "bins", List.of(points))
        .figure();
  }

  private static XYSeries bins(XYChart chart) {
    return Objects.requireNonNull(chart.getSeriesMap().get("bins"));
  }

  @Test
  void chart_holdsThePoints() {
    XYChart chart =
        figure(new AgreementPoint(0.2, 0.3, 0.1, 0.5, "10"), AgreementPoint.of(0.9, 0.8)).chart();
    XYSeries bins = bins(chart);
    assertArrayEquals(new double[] {0.2, 0.9}, bins.getXData());
    assertArrayEquals(new double[] {0.3, 0.8}, bins.getYData());
    assertEquals("probability stated", chart.getXAxisTitle());
    assertEquals("share that was so", chart.getYAxisTitle());
    assertEquals(1, chart.getStyler().getYAxisMax());
  }

  @Test
  void beyondTheScale_isDrawnAtItsEdge() {
    XYSeries bins = bins(figure(AgreementPoint.of(-7, 1.2)).chart());
    assertArrayEquals(new double[] {0}, bins.getXData());
    assertArrayEquals(new double[] {1}, bins.getYData());
  }

  @Test
  void noPoints_isSaidInTheLegend() {
    assertEquals("bins (no points)", bins(figure().chart()).getLabel());
  }

  /** The second label would lie over the first. */
  @Test
  void label_overAnother_isLeftOut() {
    AgreementPoint first = new AgreementPoint(0.5, 0.5, 0.4, 0.6, "10");
    AgreementPoint near = new AgreementPoint(0.505, 0.5, 0.4, 0.6, "10");
    AgreementPoint apart = new AgreementPoint(0.7, 0.5, 0.4, 0.6, "10");
    int one = glyphs(figure(first));
    assertEquals(one, glyphs(figure(first, near)));
    assertEquals(one + 1, glyphs(figure(first, apart)));
  }

  /** Labels are filled outlines of text; dots and whiskers are strokes. */
  private static int glyphs(Figure figure) {
    return new String(figure.svg(), StandardCharsets.UTF_8).split("stroke:none", -1).length;
  }

  @Test
  void samePoints_sameBytes() {
    AgreementPoint point = new AgreementPoint(0.5, 0.5, 0.4, 0.6, "10");
    assertArrayEquals(figure(point).png(72), figure(point).png(72));
  }

  @Test
  void badArguments_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> AgreementPoint.of(Double.NaN, 0));
    assertThrows(IllegalArgumentException.class, () -> new AgreementPoint(0, 0, 0.5, 0.4, ""));
    assertThrows(IllegalArgumentException.class, () -> new AgreementPlot.Axes("x", "y", 1, 1));
    assertThrows(
        IllegalArgumentException.class, () -> new AgreementPlot.Axes("x", "y", 0, Double.NaN));
  }
}
