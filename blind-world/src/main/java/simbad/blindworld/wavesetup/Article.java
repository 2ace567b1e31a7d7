package simbad.blindworld.wavesetup;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simbad.blindworld.check.Checks;
import simbad.blindworld.wave.Outline;
import simbad.blindworld.wave.Upright;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Point;

/**
 * An obstacle as one buys it: what it is, its cross-section as its user draws it, the cross-section
 * that it has, and its height.
 *
 * @param kind a word for it
 * @param corners as a scene has them
 * @param outline as sound meets it
 * @param heightM above the floor
 */
public record Article(String kind, List<Point> corners, Outline outline, double heightM) {

  private static final List<String> KINDS =
      List.of(
          "round",
          "round",
          "round",
          "pole",
          "pole",
          "square",
          "box",
          "strip",
          "angle",
          "channel",
          "triangle",
          "bar");

  private static final List<Double> HEIGHTS_M = List.of(0.25, 0.6, 1.2);

  /** Copies the corners. */
  public Article {
    Checks.positive("height", heightM);
    corners = List.copyOf(corners);
  }

  /** True for one whose echo is the same from all sides. */
  public boolean isRound() {
    return kind.equals("round") || kind.equals("pole");
  }

  /** Where it stands before an axis at a height. */
  public Upright upright(double mountHeightM) {
    return new Upright(-mountHeightM, heightM - mountHeightM);
  }

  /** One drawn at random. */
  static Article draw(Chance random) {
    String kind = KINDS.get(random.nextInt(KINDS.size()));
    double height = HEIGHTS_M.get(random.nextInt(HEIGHTS_M.size()));
    double size = 0.001 * random.nextInt(25, 61);
    double thick = 0.0001 * random.nextInt(12, 31);
    return switch (kind) {
      case "round" -> round(kind, 36, Math.max(0.015, size / 2), height);
      case "pole" -> round(kind, 60, size, height);
      case "square" -> of(kind, regular(4, size / Math.sqrt(2)), height);
      case "box" -> of(kind, regular(4, 0.1 / Math.sqrt(2)), height);
      case "triangle" -> of(kind, regular(3, size / Math.sqrt(3)), height);
      case "angle" -> of(kind, angle(size, thick), height);
      case "channel" -> of(kind, channel(size, thick), height);
      case "bar" -> of(kind, slab(2 * size, size / 2), height);
      default -> of(kind, slab(2 * size, thick), height);
    };
  }

  private static Article of(String kind, List<Point> corners, double heightM) {
    return new Article(kind, corners, Outline.of(corners), heightM);
  }

  /** Its user draws many corners, sound meets a circle. */
  private static Article round(String kind, int count, double radiusM, double heightM) {
    return new Article(kind, regular(count, radiusM), Outline.round(radiusM), heightM);
  }

  static List<Point> regular(int corners, double radiusM) {
    return IntStream.range(0, corners)
        .mapToObj(
            i -> {
              double a = 2 * Math.PI * i / corners + Math.PI / corners;
              return point(radiusM * StrictMath.cos(a), radiusM * StrictMath.sin(a));
            })
        .toList();
  }

  static List<Point> slab(double widthM, double thickM) {
    double x = widthM / 2;
    double z = thickM / 2;
    return List.of(point(-x, -z), point(x, -z), point(x, z), point(-x, z));
  }

  private static List<Point> angle(double legM, double thickM) {
    double half = legM / 2;
    double inner = half - thickM;
    return List.of(
        point(-half, -half),
        point(half, -half),
        point(half, half),
        point(inner, half),
        point(inner, -inner),
        point(-half, -inner));
  }

  private static List<Point> channel(double widthM, double thickM) {
    double x = widthM / 2;
    double z = widthM / 4;
    List<Point> corners = new ArrayList<>();
    corners.add(point(-x, -z));
    corners.add(point(x, -z));
    corners.add(point(x, z));
    corners.add(point(x - thickM, z));
    corners.add(point(x - thickM, thickM - z));
    corners.add(point(thickM - x, thickM - z));
    corners.add(point(thickM - x, z));
    corners.add(point(-x, z));
    return corners;
  }

  /** To a tenth of a millimetre, as it will be written. */
  private static Point point(double xM, double zM) {
    return new Point(Math.round(xM * 1e4) / 1e4, Math.round(zM * 1e4) / 1e4);
  }
}
