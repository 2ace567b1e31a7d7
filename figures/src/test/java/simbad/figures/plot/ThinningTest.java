package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Line2D;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ThinningTest {
  private static final double TOLERANCE_M = 0.0005;

  @Test
  void shortCurve_isKeptAsItIs() {
    PolarSeries table = PlotSamples.tableSeries();
    assertSame(table.points(), Thinning.thin(table, 3.5, 1));
  }

  @Test
  void straightLine_keepsItsEnds() {
    List<PolarPoint> line =
        IntStream.range(0, 5000).mapToObj(i -> PolarPoint.ofOffset(0.001 * i, 2)).toList();
    assertEquals(List.of(line.get(0), line.get(4999)), Thinning.within(line, TOLERANCE_M));
  }

  @Test
  void backAndForth_keepsTheTurningPoint() {
    List<PolarPoint> line =
        IntStream.range(0, 3001)
            .mapToObj(i -> PolarPoint.ofOffset(0.001 * (1500 - Math.abs(1500 - i)), 2))
            .toList();
    assertEquals(1.5, Thinning.within(line, TOLERANCE_M).get(1).xM(), 1e-9);
  }

  @Test
  void circle_staysWithinTheTolerance() {
    List<PolarPoint> circle = PlotSamples.circle(2.5, 31_416);
    List<PolarPoint> kept = Thinning.thin(lines(circle), 3, 1);
    assertTrue(kept.size() < 400, () -> kept.size() + " points");
    circle.forEach(p -> assertTrue(distance(kept, p) <= TOLERANCE_M + 1e-12));
  }

  private static double distance(List<PolarPoint> curve, PolarPoint p) {
    return IntStream.range(1, curve.size())
        .mapToDouble(i -> distance(curve.get(i - 1), curve.get(i), p))
        .min()
        .orElseThrow();
  }

  private static double distance(PolarPoint a, PolarPoint b, PolarPoint p) {
    return Line2D.ptSegDist(a.xM(), a.zM(), b.xM(), b.zM(), p.xM(), p.zM());
  }

  @Test
  void noisyTrace_meetsTheBudget() {
    List<PolarPoint> trace = PlotSamples.wobbling(PlotSamples.angleTable(), 800);
    assertTrue(Thinning.thin(lines(trace), 3.5, 3).size() <= Thinning.BUDGET / 3);
  }

  @Test
  void onePlace_isTwoPoints() {
    List<PolarPoint> rest =
        IntStream.range(0, 3000).mapToObj(i -> PlotSamples.point(0, 1)).toList();
    assertEquals(2, Thinning.thin(lines(rest), 3, 1).size());
  }

  @Test
  void cloud_keepsOnePointACell() {
    List<PolarPoint> circle = PlotSamples.circle(1, 40_000);
    PolarSeries cloud = new PolarSeries("c", SeriesRole.NOISY, SeriesStyle.POINTS, circle);
    List<PolarPoint> kept = Thinning.thin(cloud, 3, 2);
    assertTrue(kept.size() <= Thinning.BUDGET / 2 && kept.size() > 1000);
  }

  private static PolarSeries lines(List<PolarPoint> points) {
    return new PolarSeries("trace", SeriesRole.SHADOW, SeriesStyle.LINE, points);
  }
}
