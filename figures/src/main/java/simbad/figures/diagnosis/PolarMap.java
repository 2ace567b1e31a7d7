package simbad.figures.diagnosis;

import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Svg;
import simbad.figures.page.Svg.Spot;
import simbad.figures.page.Table;
import simbad.sonar.scene.Obstacle;

/**
 * The mean gap round an obstacle, by bearing and distance, seen from above in the obstacle's own
 * frame: bearing 0 points down the page, 90 to the right.
 */
final class PolarMap {
  /** How many shades there are; the page's style sheet names them h0 to h8. */
  static final int SHADES = 9;

  private static final int SIZE = 420;
  private static final int HEIGHT = 478;
  private static final int CENTRE = 210;
  private static final Spot MIDDLE = new Spot(CENTRE, CENTRE);
  private static final int RADIUS = 160;
  private static final int SECTORS = 36;
  private static final int RINGS = 10;
  private static final int LABEL_GAP = 16;
  private static final double USUAL = 0.98;

  /** Less than half a turn, so that an arc goes the short way. */
  private static final int LONGEST_RUN = SECTORS / 2 - 1;

  private static final int NO_SHADE = -1;
  private static final double SECTOR_DEG = 360.0 / SECTORS;

  private final Obstacle obstacle;
  private final List<RowFinding> rows;
  private final AxisScale radius;
  private final int rings;

  /**
   * Lays a map out.
   *
   * @param obstacle in its middle
   * @param rows nearest to that obstacle; at least one
   */
  PolarMap(Obstacle obstacle, List<RowFinding> rows) {
    this.obstacle = obstacle;
    this.rows = rows;
    double most = rows.stream().mapToDouble(row -> row.distanceM().orElse(0)).max().orElse(1);
    double step = AxisScale.roundStep(most / RINGS);
    rings = (int) Math.ceil(most / step - 1e-9);
    radius = new AxisScale(0, rings * step, step);
  }

  /** The mean gap in centimetres that 98 of 100 cells do not exceed. */
  double greatestCm(ToDoubleFunction<RowFinding> gapCm) {
    double[] known =
        Arrays.stream(cells(gapCm))
            .flatMapToDouble(Arrays::stream)
            .filter(cell -> !Double.isNaN(cell))
            .toArray();
    return RowSurvey.quantile(known, USUAL);
  }

  /**
   * Draws the map.
   *
   * @param title what it shows
   * @param gapCm of a row
   * @param scale of the colours
   */
  Html draw(String title, ToDoubleFunction<RowFinding> gapCm, AxisScale scale) {
    Svg svg = new Svg(SIZE, HEIGHT, title);
    double[][] cells = cells(gapCm);
    shades(svg, cells, scale);
    svg.tell("centre", CENTRE + " " + CENTRE)
        .tell("ring", Svg.number(pixels(radius.step())))
        .tell("metres", radius.label(radius.step()))
        .tell("cells", numbers(cells));
    threshold(svg);
    rings(svg);
    colours(svg, scale);
    return svg.html();
  }

  /** All cells of a shade are one shape: a shape each would be most of the page. */
  private void shades(Svg svg, double[][] cells, AxisScale scale) {
    String[] paths = new String[SHADES];
    Arrays.fill(paths, "");
    for (int ring = 0; ring < rings; ring++) {
      int sector = 0;
      while (sector < SECTORS) {
        int shade = shade(cells[ring][sector], scale);
        int end = sector + 1;
        while (end < SECTORS
            && end - sector < LONGEST_RUN
            && shade(cells[ring][end], scale) == shade) {
          end++;
        }
        if (shade != NO_SHADE) {
          paths[shade] += cells(ring, sector, end);
        }
        sector = end;
      }
    }
    for (int shade = 0; shade < SHADES; shade++) {
      if (!paths[shade].isEmpty()) {
        svg.path(paths[shade], "shade h" + shade, "");
      }
    }
  }

  private static int shade(double gapCm, AxisScale scale) {
    return Double.isNaN(gapCm)
        ? NO_SHADE
        : (int) Math.max(0, Math.min(SHADES - 1.0, scale.share(gapCm) * SHADES));
  }

  /** What the page's script reads: a comma between sectors, a semicolon between rings. */
  private static String numbers(double[][] cells) {
    return Arrays.stream(cells)
        .map(
            ring ->
                Arrays.stream(ring)
                    .mapToObj(cm -> Double.isNaN(cm) ? "" : Numbers.fixed(cm, cm < 10 ? 2 : 1))
                    .collect(Collectors.joining(",")))
        .collect(Collectors.joining(";"));
  }

  /** The mean gap of all distances, by bearing, before and after. */
  Table table() {
    Table table = Table.of("#bearing, degrees", "#rows", "#before, cm", "#after, cm");
    for (int sector = 0; sector < SECTORS; sector++) {
      int one = sector;
      List<RowFinding> there = rows.stream().filter(row -> sectorOf(row) == one).toList();
      if (!there.isEmpty()) {
        table.row(
            Numbers.number(sector * SECTOR_DEG),
            there.size(),
            Numbers.fixed(mean(there, row -> row.before().gapCm()), 2),
            Numbers.fixed(mean(there, row -> row.after().gapCm()), 2));
      }
    }
    return table;
  }

  private static double mean(List<RowFinding> rows, ToDoubleFunction<RowFinding> gapCm) {
    return rows.stream().mapToDouble(gapCm).average().orElse(0);
  }

  private static int sectorOf(RowFinding row) {
    return (int) Math.floor(row.bearingDeg() / SECTOR_DEG + 0.5) % SECTORS;
  }

  /** Mean by ring and sector; NaN where no row lies. */
  private double[][] cells(ToDoubleFunction<RowFinding> gapCm) {
    double[][] sums = new double[rings][SECTORS];
    int[][] counts = new int[rings][SECTORS];
    for (RowFinding row : rows) {
      int ring = (int) Math.min(rings - 1.0, row.distanceM().orElse(0) / radius.step());
      int sector = sectorOf(row);
      sums[ring][sector] += gapCm.applyAsDouble(row);
      counts[ring][sector]++;
    }
    for (int ring = 0; ring < rings; ring++) {
      for (int sector = 0; sector < SECTORS; sector++) {
        sums[ring][sector] /= counts[ring][sector];
      }
    }
    return sums;
  }

  /** Cells of a ring beside each other, up to an end that is not among them. */
  private String cells(int ring, int sector, int end) {
    double inner = ring * radius.step();
    double outer = inner + radius.step();
    double from = (sector - 0.5) * SECTOR_DEG;
    double to = (end - 0.5) * SECTOR_DEG;
    return "M"
        + at(inner, from)
        + "L"
        + at(outer, from)
        + arc(outer, 0)
        + at(outer, to)
        + "L"
        + at(inner, to)
        + (ring == 0 ? "" : arc(inner, 1) + at(inner, from))
        + "Z";
  }

  private String arc(double distanceM, int sweep) {
    String r = Svg.number(pixels(distanceM));
    return "A" + r + " " + r + " 0 0 " + sweep + " ";
  }

  /** Bearings grow counter-clockwise on the page, from straight down. */
  private String at(double distanceM, double bearingDeg) {
    double bearing = Math.toRadians(bearingDeg);
    return Svg.at(
        CENTRE + pixels(distanceM) * Math.sin(bearing),
        CENTRE + pixels(distanceM) * Math.cos(bearing));
  }

  private double pixels(double distanceM) {
    return Math.min(1, radius.share(distanceM)) * RADIUS;
  }

  /** What the simulator believes, so that one sees on which side of the edge the gap lies. */
  private void threshold(Svg svg) {
    StringBuilder path = new StringBuilder();
    for (int degree = 0; degree < 360; degree++) {
      double threshold = obstacle.detection().thresholdM(Math.toRadians(degree));
      path.append(degree == 0 ? "M" : "L").append(at(threshold, degree));
    }
    svg.path(path + "Z", "edge", "threshold that the simulator believes");
  }

  private void rings(Svg svg) {
    svg.circle(MIDDLE, RADIUS, "rim", "");
    svg.circle(MIDDLE, 2.5, "dot", "");
    int every = Math.max(1, rings / 4);
    for (int ring = every; ring <= rings; ring += every) {
      double distance = ring * radius.step();
      if (ring < rings) {
        svg.circle(MIDDLE, pixels(distance), "ring", "");
      }
    }
    double beyond = RADIUS + LABEL_GAP;
    svg.words(new Spot(CENTRE, CENTRE + beyond + 4), "middle", "0°");
    svg.words(new Spot(CENTRE + beyond - 8, CENTRE + 4), "start", "90°");
    svg.words(new Spot(CENTRE, CENTRE - beyond + 8), "middle", "180°");
    svg.words(new Spot(CENTRE - beyond + 8, CENTRE + 4), "end", "270°");
    svg.words(
        new Spot(SIZE - 4, 16),
        "end",
        "rim "
            + radius.label(radius.high())
            + " m, rings "
            + radius.label(every * radius.step())
            + " m");
  }

  private static void colours(Svg svg, AxisScale scale) {
    double left = 60;
    double width = (SIZE - 2 * left) / SHADES;
    double top = HEIGHT - 56;
    for (int shade = 0; shade < SHADES; shade++) {
      svg.rectangle(
          new Spot(left + shade * width, top), new Spot(width, 12), "shade h" + shade, "");
    }
    for (double tick : scale.ticks()) {
      double x = left + scale.share(tick) * width * SHADES;
      svg.words(new Spot(x, top + 27), "middle", scale.label(tick));
    }
    svg.words(new Spot(SIZE / 2.0, HEIGHT - 10), "middle", "mean gap, cm (and above)");
  }
}
