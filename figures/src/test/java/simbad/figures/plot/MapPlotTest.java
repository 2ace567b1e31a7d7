package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.knowm.xchart.XYChart;
import simbad.experiments.run.ShareGrid;

class MapPlotTest {
  @Test
  void chart_spansTheGridAndHoldsTheTable() {
    PlotFigure figure = Gallery.map().figure();
    XYChart chart = figure.chart();
    assertEquals(3.5, chart.getStyler().getXAxisMax());
    assertEquals(73, PlotSamples.seriesOf(figure, "threshold table").getXData().length);
    assertTrue(chart.getSeriesMap().containsKey("obstacle"));
  }

  @Test
  void aspect_isSquare() {
    XYChart chart = Gallery.map().figure().chart();
    double across = chart.getScreenXFromChart(3) - chart.getScreenXFromChart(-3);
    double down = chart.getScreenYFromChart(-3) - chart.getScreenYFromChart(3);
    assertEquals(1, across / down, 1e-6);
  }

  @Test
  void cells_lieWhereTheFrameSays() throws IOException {
    // Dark only where x > 0 and z > 0: to the right and down the page.
    PlotFigure figure = figure(ShareGrid.of(2, 1, (xM, zM) -> xM > 0 && zM > 0 ? 1 : 0));
    assertEquals(Ramp.colour(1), colourAt(figure, 0.6, 0.3));
    assertEquals(Ramp.colour(0), colourAt(figure, 0.6, -0.3));
    assertEquals(Ramp.colour(0), colourAt(figure, -0.6, 0.3));
  }

  private static Color colourAt(PlotFigure figure, double xM, double zM) throws IOException {
    var image = ImageIO.read(new ByteArrayInputStream(figure.png(72)));
    XYChart chart = figure.chart();
    int headingPt = figure.heightPt() - chart.getHeight();
    return new Color(
        image.getRGB(
            (int) chart.getScreenXFromChart(xM), (int) chart.getScreenYFromChart(-zM) + headingPt));
  }

  @Test
  void colours_darkenFromPaleToDark() {
    double before = Double.MAX_VALUE;
    for (int i = 0; i <= 100; i++) {
      double luminance = luminance(Ramp.colour(i / 100.0));
      assertTrue(luminance < before, "at " + i);
      before = luminance;
    }
  }

  private static double luminance(Color c) {
    return 0.2126 * linear(c.getRed())
        + 0.7152 * linear(c.getGreen())
        + 0.0722 * linear(c.getBlue());
  }

  private static double linear(int channel) {
    return Math.pow(channel / 255.0, 2.2);
  }

  @Test
  void bar_standsBesideTheChart() {
    PlotFigure figure = Gallery.map().figure();
    assertTrue(figure.widthPt() > figure.chart().getWidth());
  }

  @Test
  void svg_holdsTheMapAsOneLosslessImage() {
    String svg = new String(Gallery.map().figure().svg(), StandardCharsets.UTF_8);
    // One for the map, one for the bar.
    assertEquals(3, svg.split("data:image/png", -1).length);
  }

  @Test
  void oneCell_andNoSeries_areDrawn() {
    assertTrue(figure(ShareGrid.of(1, 2, (xM, zM) -> 0.5)).svg().length > 1000);
  }

  @Test
  void grid_asksAtTheMiddlesOfItsCells() {
    ShareGrid grid = ShareGrid.of(4, 2, (xM, zM) -> (xM + 2) / 4);
    assertEquals(0.125, grid.share(0, 3), 1e-12);
    assertEquals(0.875, grid.share(3, 0), 1e-12);
  }

  @Test
  void badGrids_areRefused() {
    checkRefused(0, 1, List.of());
    checkRefused(2, 1, List.of(0.5));
    checkRefused(1, 0, List.of(0.5));
    checkRefused(1, Double.NaN, List.of(0.5));
    checkRefused(1, 1, List.of(1.1));
    checkRefused(1, 1, List.of(Double.NaN));
    checkRefused(2, 1, Collections.nCopies(4, -0.1));
  }

  private static void checkRefused(int cells, double halfWidthM, List<Double> shares) {
    assertThrows(IllegalArgumentException.class, () -> new ShareGrid(cells, halfWidthM, shares));
  }

  private static PlotFigure figure(ShareGrid grid) {
    return new MapPlot(PlotSamples.CAPTION, "share", grid, List.of(), List.of()).figure();
  }
}
