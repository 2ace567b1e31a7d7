package simbad.scattering;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OutlineFile;
import simbad.sonar.frame.Point;
import simbad.sonar.level.Air;
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

  static ThesisThresholds thesis() {
    return new ThesisThresholds(square(2 * HALF_INCH_M), circle(HALF_INCH_M, 24), Air.ROOM);
  }

  /** A cross-section of the thesis, or of data/obstacles. */
  static List<Outline> section(String name) throws DataFormatException {
    return switch (name) {
      case "square" -> List.of(square(2 * HALF_INCH_M));
      case "round" -> List.of(circle(HALF_INCH_M, 24));
      case "angle" -> List.of(angle());
      default -> OutlineFile.read(Path.of("..", "data", "obstacles", name, "outline.csv")).parts();
    };
  }

  static Backscatter echo(Outline outline) {
    return Backscatter.of(List.of(outline), Air.ROOM, KnownThresholds.BEARINGS);
  }

  static ThresholdPrediction predicted(Outline outline, FittedReceiver calibration) {
    return ThresholdPrediction.of(echo(outline), Air.ROOM, SRF04, calibration);
  }
}
