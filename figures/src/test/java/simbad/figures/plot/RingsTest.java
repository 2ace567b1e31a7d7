package simbad.figures.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class RingsTest {
  @ParameterizedTest
  @CsvSource({"3.16, 0.5, 7", "2.5, 0.5, 5", "20, 5, 4", "0.08, 0.02, 4", "0, 0.2, 5", "1, 0.2, 5"})
  void rings_areRoundAndHoldTheData(double radiusM, double stepM, int count) {
    Rings rings = Rings.around(radiusM);
    assertEquals(stepM, rings.stepM(), 1e-12);
    assertEquals(count, rings.count());
    assertTrue(rings.outermostM() >= radiusM && rings.halfWidthM() > rings.outermostM());
  }

  @Test
  void labels_avoidTheCurves() {
    // Petals fill every direction but that between 270 and 300 degrees.
    List<PolarPoint> points =
        PlotSamples.circle(1, 360).stream()
            .map(p -> isFree(p) ? new PolarPoint(p.bearingRad(), 0) : p)
            .toList();
    List<PlotCurve> curves = new ArrayList<>();
    for (int i = 1; i <= 20; i++) {
      curves.addAll(PlanView.curves(List.of(scaled(points, i)), 1));
    }
    double placeRad = RingLabelPlace.bearingRad(Rings.around(1), curves);
    assertEquals(285, Math.toDegrees(placeRad), 1e-9);
  }

  private static boolean isFree(PolarPoint p) {
    double deg = Math.toDegrees(p.bearingRad());
    return deg > 266 && deg < 304;
  }

  private static PolarSeries scaled(List<PolarPoint> points, int twentieths) {
    List<PolarPoint> smaller =
        points.stream()
            .map(p -> new PolarPoint(p.bearingRad(), p.radiusM() * twentieths / 20))
            .toList();
    return new PolarSeries("p" + twentieths, SeriesRole.OTHER, SeriesStyle.LINE, smaller);
  }

  @Test
  void labels_standUpperRight_whereNothingIsInTheWay() {
    assertEquals(105, Math.toDegrees(RingLabelPlace.bearingRad(Rings.around(1), List.of())), 1e-9);
  }

  @ParameterizedTest
  @CsvSource({"0.3, 0.5, 0.2", "7, 10, 5", "1, 1, 1", "0.0021, 0.005, 0.002"})
  void steps_areOneTwoOrFive(double value, double up, double down) {
    assertEquals(up, Steps.roundUp(value), 1e-15);
    assertEquals(down, Steps.roundDown(value), 1e-15);
  }

  @ParameterizedTest
  @CsvSource({"0.1, 0.1", "-0.0, 0", "20, 20", "1e-3, 0.001", "0.30000000000000004, 0.3"})
  void numbers_areWrittenPlainly(double value, String label) {
    assertEquals(label, Steps.label(value));
  }

  @Test
  void multiples_includeBothBounds() {
    assertEquals(List.of(-0.2, -0.1, 0.0, 0.1, 0.2), Steps.multiples(-0.2, 0.2, 0.1));
  }
}
