package simbad.figures.report;

import java.util.ArrayList;
import java.util.List;
import simbad.experiments.run.DetectionMap;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.ShareGrid;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Html;
import simbad.figures.page.Svg;
import simbad.figures.page.Svg.Spot;
import simbad.sonar.shape.ThresholdTable;

/**
 * Where a belt and the table disagree round an obstacle, seen from above, with the table's edge.
 */
final class DisagreementView {
  private static final int SIZE = 420;
  private static final int HEIGHT = 464;
  private static final double LEFT = 50;
  private static final double TOP = 8;
  private static final double SIDE = 362;
  private static final int MOST_SHADE = 8;

  private final ShareGrid grid;
  private final Svg svg;

  private DisagreementView(RunResult result) {
    grid = result.map().disagreement();
    svg =
        new Svg(
            SIZE,
            HEIGHT,
            "Where the "
                + result.sensor().word()
                + " belt disagrees round "
                + result.type().name());
  }

  static Html of(RunResult result) {
    DisagreementView view = new DisagreementView(result);
    for (int wrong = 0; wrong <= DetectionMap.HEADINGS; wrong++) {
      view.cells(wrong);
    }
    view.axes();
    view.edge(result.type().thresholds().table());
    view.colours();
    return view.svg.html();
  }

  private static String shade(int wrong) {
    return "h" + Math.round((double) MOST_SHADE * wrong / DetectionMap.HEADINGS);
  }

  private int wrong(int column, int row) {
    return (int) Math.round(DetectionMap.HEADINGS * grid.share(column, row));
  }

  /** All places of a shade are one shape, of rows as long as they go. */
  private void cells(int wrong) {
    StringBuilder rows = new StringBuilder();
    int count = 0;
    for (int row = 0; row < grid.cells(); row++) {
      int column = 0;
      while (column < grid.cells()) {
        int end = column;
        while (end < grid.cells() && wrong(end, row) == wrong) {
          end++;
        }
        if (end > column) {
          rows.append("M" + column + " " + row + "h" + (end - column));
          count += end - column;
        }
        column = Math.max(end, column + 1);
      }
    }
    draw(wrong, count, rows.toString());
  }

  /** Most places of most maps agree: they are the ground under the others. */
  private void draw(int wrong, int count, String rows) {
    String tip =
        "disagrees at "
            + wrong
            + " of "
            + DetectionMap.HEADINGS
            + " headings: "
            + count
            + " of "
            + grid.cells() * grid.cells()
            + " places";
    if (wrong == 0) {
      svg.rectangle(new Spot(LEFT, TOP), new Spot(SIDE, SIDE), "shade " + shade(0), tip);
    } else if (count > 0) {
      svg.cells(new Spot(LEFT, TOP), SIDE / grid.cells(), rows, shade(wrong), tip);
    }
  }

  private double pixels(double metres) {
    return SIDE * (metres + grid.halfWidthM()) / (2 * grid.halfWidthM());
  }

  private void axes() {
    double half = grid.halfWidthM();
    double step = AxisScale.roundStep(half / 2);
    AxisScale scale = new AxisScale(-half, half, step);
    for (double tick = -Math.floor(half / step) * step; tick <= half; tick += step) {
      double right = LEFT + pixels(tick);
      double down = TOP + pixels(tick);
      svg.line(new Spot(right, TOP + SIDE), new Spot(right, TOP + SIDE + 4), "axis");
      svg.words(new Spot(right, TOP + SIDE + 17), "middle", scale.label(tick));
      svg.line(new Spot(LEFT - 4, down), new Spot(LEFT, down), "axis");
      svg.words(new Spot(LEFT - 7, down + 5), "end", scale.label(tick));
    }
    svg.words(new Spot(LEFT + SIDE / 2, TOP + SIDE + 34), "middle", "x, m");
    svg.wordsUpward(new Spot(15, TOP + SIDE / 2), "z, m (down the page)");
  }

  private void edge(ThresholdTable table) {
    List<Spot> edge = new ArrayList<>();
    for (int i = 0; i <= table.size(); i++) {
      double bearing = table.bearingRad(i % table.size());
      double thresholdM = table.valueM(i % table.size());
      edge.add(
          new Spot(
              LEFT + pixels(thresholdM * Math.sin(bearing)),
              TOP + pixels(thresholdM * Math.cos(bearing))));
    }
    svg.curve(edge, Integer.MAX_VALUE, "seam");
    svg.curve(edge, Integer.MAX_VALUE, "table");
  }

  private void colours() {
    double width = 26;
    double left = LEFT + 150;
    double top = HEIGHT - 30;
    for (int wrong = 0; wrong <= DetectionMap.HEADINGS; wrong++) {
      double at = left + wrong * width;
      svg.rectangle(new Spot(at, top), new Spot(width, 12), "shade " + shade(wrong), "");
      svg.words(new Spot(at + width / 2, top + 26), "middle", "" + wrong);
    }
    svg.words(new Spot(left - 8, top + 12), "end", "headings that disagree");
  }
}
