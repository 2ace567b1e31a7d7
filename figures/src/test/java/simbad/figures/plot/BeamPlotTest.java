package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.knowm.xchart.XYSeries;

class BeamPlotTest {
  private static final String LINE = "sensitivity";
  private static final String DOTS = "points from the sensor's file";
  private static final String CONE = "cone that stands for it";

  private static Map<String, XYSeries> series(List<Double> deg, List<Double> db) {
    return new BeamPlot(new Caption("title", "source"), deg, db, 20)
        .figure()
        .chart()
        .getSeriesMap();
  }

  /** The corners of a coarse curve are the file's, not the sensor's. */
  @Test
  void coarseAngles_areDotted_fineOnesAreNot() {
    var coarse = series(List.of(0.0, 5.0, 10.0), List.of(0.0, -1.0, -4.0));
    assertEquals(Set.of(LINE, DOTS, CONE), coarse.keySet());
    assertArrayEquals(
        new double[] {-10, -5, 0, 0, 5, 10}, Objects.requireNonNull(coarse.get(DOTS)).getXData());
    var fine = series(List.of(0.0, 1.0, 3.0), List.of(0.0, -1.0, -4.0));
    assertEquals(Set.of(LINE, CONE), fine.keySet());
  }

  /** Between -30 and -42 dB the floor of -36 dB is crossed half-way; nothing is drawn along it. */
  @Test
  void lineBelowThePlot_isCutOff() {
    XYSeries line =
        Objects.requireNonNull(
            series(List.of(0.0, 2.0, 4.0, 6.0), List.of(0.0, -30.0, -42.0, -30.0)).get(LINE));
    assertArrayEquals(
        new double[] {-6, -5, -5, -3, -3, -2, 0, 0, 2, 3, 3, 5, 5, 6}, line.getXData(), 1e-9);
    double gap = Double.NaN;
    assertArrayEquals(
        new double[] {-30, -36, gap, gap, -36, -30, 0, 0, -30, -36, gap, gap, -36, -30},
        line.getYData(),
        1e-9);
  }
}
