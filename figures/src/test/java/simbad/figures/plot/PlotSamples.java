package simbad.figures.plot;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.knowm.xchart.XYSeries;

/** The measured angle table, and made-up traces round it. */
final class PlotSamples {
  static final Caption CAPTION =
      new Caption("Angle extrusion, 25 mm", "table: measured (Kranz 2014, appendix A.2)");

  /**
   * The two legs of the angle, 25 mm long and 2 mm thick, the corner at the origin's lower left.
   */
  static final List<PolarPoint> OUTLINE =
      outline(-12.5, -12.5, -10.5, -12.5, -10.5, 10.5, 12.5, 10.5, 12.5, 12.5, -12.5, 12.5);

  private PlotSamples() {}

  static List<PolarPoint> angleTable() {
    try (BufferedReader lines = new BufferedReader(resource("angle-25mm.csv"))) {
      return lines
          .lines()
          .filter(line -> !line.startsWith("#") && !line.startsWith("bearing"))
          .map(line -> line.split(",", -1))
          .map(f -> point(Double.parseDouble(f[0]), Double.parseDouble(f[1])))
          .toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static InputStreamReader resource(String name) {
    return new InputStreamReader(
        Objects.requireNonNull(PlotSamples.class.getResourceAsStream(name)),
        StandardCharsets.UTF_8);
  }

  static XYSeries seriesOf(PlotFigure figure, String name) {
    return Objects.requireNonNull(figure.chart().getSeriesMap().get(name), name);
  }

  static PolarPoint point(double bearingDeg, double radiusM) {
    return new PolarPoint(Math.toRadians(bearingDeg), radiusM);
  }

  static PolarSeries tableSeries() {
    return new PolarSeries(
        "threshold table", SeriesRole.TABLE, SeriesStyle.CLOSED_LINE, angleTable());
  }

  static PolarSeries originalSeries() {
    return new PolarSeries(
        "trace, original sensor", SeriesRole.ORIGINAL, SeriesStyle.LINE, circle(2.5, 31_416));
  }

  static PolarSeries shadowSeries() {
    return new PolarSeries(
        "trace, shadow sensor", SeriesRole.SHADOW, SeriesStyle.LINE, wobbling(angleTable(), 800));
  }

  static List<PolarPoint> circle(double radiusM, int points) {
    return IntStream.range(0, points).mapToObj(i -> point(360.0 * i / points, radiusM)).toList();
  }

  /** The polygon's edges in many steps, each shifted by up to 3 mm. */
  static List<PolarPoint> wobbling(List<PolarPoint> polygon, int stepsPerEdge) {
    Random random = new Random(1);
    return IntStream.range(0, polygon.size() * stepsPerEdge)
        .mapToObj(
            i -> onEdge(polygon, i / stepsPerEdge, (double) (i % stepsPerEdge) / stepsPerEdge))
        .map(p -> shifted(p, random))
        .toList();
  }

  private static PolarPoint onEdge(List<PolarPoint> polygon, int edge, double t) {
    PolarPoint a = polygon.get(edge);
    PolarPoint b = polygon.get((edge + 1) % polygon.size());
    return PolarPoint.ofOffset(a.xM() + t * (b.xM() - a.xM()), a.zM() + t * (b.zM() - a.zM()));
  }

  private static PolarPoint shifted(PolarPoint p, Random random) {
    return PolarPoint.ofOffset(
        p.xM() + 0.003 * (2 * random.nextDouble() - 1),
        p.zM() + 0.003 * (2 * random.nextDouble() - 1));
  }

  static List<BearingError> errors(IntToDoubleFunction errorAtDegM) {
    return IntStream.range(0, 72)
        .map(i -> 5 * i)
        .mapToObj(deg -> new BearingError(Math.toRadians(deg), errorAtDegM.applyAsDouble(deg)))
        .toList();
  }

  private static List<PolarPoint> outline(double... xzMm) {
    return IntStream.range(0, xzMm.length / 2)
        .mapToObj(i -> PolarPoint.ofOffset(xzMm[2 * i] / 1000, xzMm[2 * i + 1] / 1000))
        .toList();
  }
}
