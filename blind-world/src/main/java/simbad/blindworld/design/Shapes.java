package simbad.blindworld.design;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Shadow;

/** Obstacles drawn at random: cross-sections and threshold tables that go with them. */
final class Shapes {

  private static final List<Integer> TABLE_SIZES = List.of(72, 72, 72, 72, 36, 90, 120, 60, 48);
  private static final double LEAST_THRESHOLD_M = 0.04;

  private final Chance random;

  Shapes(Chance random) {
    this.random = random;
  }

  /** An obstacle at a place; the index makes its name. */
  Obstacle obstacle(Point place, int index) {
    double turnDeg = random.nextInt(-180, 180);
    String[] kinds = {"round", "square", "angle", "hexagon", "plate", "triangle"};
    String kind = kinds[random.nextInt(kinds.length)];
    List<Point> outline =
        switch (kind) {
          case "round" -> regular(random.nextInt(16, 40), random.nextDouble(0.008, 0.06));
          case "square" -> regular(4, random.nextDouble(0.01, 0.07));
          case "hexagon" -> regular(6, random.nextDouble(0.02, 0.09));
          case "triangle" -> regular(3, random.nextDouble(0.02, 0.08));
          case "angle" -> angle(random.nextDouble(0.02, 0.08));
          default -> plate(random.nextDouble(0.05, 0.3), random.nextDouble(0.004, 0.03));
        };
    Shadow shadow =
        random.nextDouble() < 0.2
            ? Shadow.uniform(rounded(random.nextDouble(0.9, 2.8), 0.05))
            : table(kind);
    return new Obstacle(kind + (index + 1), place, Math.toRadians(turnDeg), outline, shadow);
  }

  private static List<Point> regular(int corners, double radiusM) {
    return IntStream.range(0, corners)
        .mapToObj(
            i -> {
              double a = 2 * Math.PI * i / corners + Math.PI / corners;
              return point(radiusM * StrictMath.cos(a), radiusM * StrictMath.sin(a));
            })
        .toList();
  }

  private static List<Point> plate(double halfM, double thickM) {
    return List.of(
        point(-halfM, -thickM / 2),
        point(halfM, -thickM / 2),
        point(halfM, thickM / 2),
        point(-halfM, thickM / 2));
  }

  private List<Point> angle(double legM) {
    double wall = legM * random.nextDouble(0.06, 0.2);
    double half = legM / 2;
    return List.of(
        point(-half, -half),
        point(half, -half),
        point(half, half),
        point(half - wall, half),
        point(half - wall, -half + wall),
        point(-half, -half + wall));
  }

  /** To a tenth of a millimetre, as it will be written. */
  private static Point point(double xM, double zM) {
    return new Point(rounded(xM, 1e-4), rounded(zM, 1e-4));
  }

  static double rounded(double value, double step) {
    return Math.round(value / step) * step;
  }

  private Shadow table(String kind) {
    int n = TABLE_SIZES.get(random.nextInt(TABLE_SIZES.size()));
    double step = random.nextBoolean() ? 0.02 : 0.01;
    double rough = random.nextDouble(0.005, 0.08);
    DoubleUnaryOperator law =
        switch (kind) {
          case "round" -> round();
          case "square" -> faces(4, random.nextDouble(0.2, 0.9));
          case "hexagon" -> faces(6, random.nextDouble(0.1, 0.7));
          case "triangle" -> faces(3, random.nextDouble(0.3, 0.9));
          case "plate" -> faces(2, random.nextDouble(0.5, 0.95));
          default -> lobes();
        };
    List<Double> radii = new ArrayList<>();
    for (int i = 0; i < n; i++) {
      double smooth = law.applyAsDouble(2 * Math.PI * i / n);
      double radius = smooth * (1 + rough * (2 * random.nextDouble() - 1));
      radii.add(rounded(Math.max(LEAST_THRESHOLD_M, Math.min(3.4, radius)), step));
    }
    return new Shadow(radii);
  }

  private DoubleUnaryOperator round() {
    double mean = random.nextDouble(1.1, 2.5);
    double oval = random.nextDouble(0, 0.15);
    double phase = random.nextDouble(0, 2 * Math.PI);
    return b -> mean * (1 + oval * StrictMath.cos(2 * b + phase));
  }

  /** Far before the flat sides, near before the corners. */
  private DoubleUnaryOperator faces(int count, double depth) {
    double most = random.nextDouble(1.6, 3.1);
    double sharp = random.nextDouble(0.3, 2.5);
    double phase = random.nextInt(count) * 2 * Math.PI / count;
    return b -> {
      double inner = Math.abs(StrictMath.cos(count * (b - phase) / 2));
      return most * (1 - depth + depth * StrictMath.pow(inner, sharp));
    };
  }

  /** A few lobes of their own heights and widths over a low floor. */
  private DoubleUnaryOperator lobes() {
    int count = random.nextInt(2, 6);
    double floor = random.nextDouble(0.06, 0.5);
    double[] at = random.doubles(count, 0, 2 * Math.PI).toArray();
    double[] wide = random.doubles(count, 0.15, 0.7).toArray();
    double[] high = random.doubles(count, 0.8, 3.1).toArray();
    return b -> {
      double most = floor;
      for (int i = 0; i < count; i++) {
        double beside = Math.abs(Math.IEEEremainder(b - at[i], 2 * Math.PI)) / wide[i];
        most = Math.max(most, high[i] / (1 + StrictMath.pow(beside, 6)));
      }
      return most;
    };
  }
}
