package simbad.scattering;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/** The obstacles of Kranz (2014) and what is known of their thresholds. */
final class Cases {
  static final double HALF_INCH_M = 0.0127;
  static final RangeLimits SRF04 = new RangeLimits(0.03, 6);

  private Cases() {}

  static Outline polygon(double... xz) {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < xz.length; i += 2) {
      corners.add(new Point(xz[i], xz[i + 1]));
    }
    return Outline.of(corners);
  }

  static Outline circle(double radiusM, int corners) {
    return Outline.of(
        IntStream.range(0, corners)
            .mapToObj(i -> 2 * Math.PI * i / corners)
            .map(a -> new Point(radiusM * Math.cos(a), radiusM * Math.sin(a)))
            .toList());
  }

  static Outline square(double sideM) {
    double h = sideM / 2;
    return polygon(h, h, h, -h, -h, -h, -h, h);
  }

  static Outline angle() {
    double h = HALF_INCH_M;
    double in = h - h / 8;
    return polygon(-h, -h, h, -h, h, h, in, h, in, -in, -h, -in);
  }

  static ThresholdTable angleTable() {
    try {
      return ThresholdTable.of(
          Files.readAllLines(Path.of("..", "data", "threshold-plots", "angle-25mm.csv")).stream()
              .filter(line -> Character.isDigit(line.charAt(0)))
              .mapToDouble(line -> Double.parseDouble(line.split(",", 2)[1]))
              .toArray());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static KnownThresholds measuredAngle() {
    return KnownThresholds.of(List.of(angle()), angleTable(), Air.ROOM);
  }

  /** "About two meters" all round (section 4.1.3). */
  static KnownThresholds saidOfRound() {
    return new KnownThresholds(echo(circle(HALF_INCH_M, 24)), Map.of(0, 2.0));
  }

  /** "About 250cm along the flat sides", about 20 cm towards the corners (section 4.1.2). */
  static List<KnownThresholds> saidOfSquare() {
    Backscatter square = echo(square(2 * HALF_INCH_M));
    Map<Integer, Double> corner = new HashMap<>();
    IntStream.rangeClosed(5, 13).forEach(i -> corner.put(i, 0.2)); // 25 to 65 degrees
    return List.of(
        new KnownThresholds(square, Map.of(0, 2.5)), new KnownThresholds(square, corner));
  }

  static Backscatter echo(Outline outline) {
    return Backscatter.of(List.of(outline), Air.ROOM, KnownThresholds.BEARINGS);
  }

  static ThresholdPrediction predicted(Outline outline, Calibration calibration) {
    return ThresholdPrediction.of(echo(outline), Air.ROOM, SRF04, calibration);
  }
}
