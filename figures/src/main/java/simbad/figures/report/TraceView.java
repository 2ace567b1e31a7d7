package simbad.figures.report;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.Trace;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Html;
import simbad.figures.page.Svg;
import simbad.figures.page.Svg.Spot;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.ThresholdTable;

/**
 * Where robots drove round an obstacle, over its table, seen from above in the obstacle's own
 * frame: bearing 0 points down the page, 90 to the right.
 */
final class TraceView {
  private static final int SIZE = 420;
  private static final int HEIGHT = 434;
  private static final Spot CENTRE = new Spot(210, 218);
  private static final double RADIUS = 176;
  private static final double BEYOND = 16;

  private final ObstacleType type;
  private final List<RunResult> results;
  private final AxisScale radius;
  private final Svg svg;

  private TraceView(ObstacleType type, List<RunResult> results) {
    this.type = type;
    this.results = results;
    radius = AxisScale.over(0, Math.max(reachM(), 0.1), 4);
    svg = new Svg(SIZE, HEIGHT, "Traces round " + type.name() + ", seen from above");
  }

  /**
   * Draws the view.
   *
   * @param results of one obstacle; at least one
   * @param table name of the page's table that has a row for each bearing
   * @param most how many corners a trace may have
   */
  static Html of(List<RunResult> results, String table, int most) {
    TraceView view = new TraceView(results.get(0).type(), results);
    view.svg.readRound(table, CENTRE, RADIUS);
    view.rings();
    view.body();
    for (RunResult result : SensorStyle.drawn(results)) {
      view.svg.curve(view.places(result.trace()), most, SensorStyle.of(result));
    }
    view.svg.curve(view.edge(), Integer.MAX_VALUE, "table");
    return view.svg.html();
  }

  private double reachM() {
    double most = type.thresholds().table().greatestM();
    for (RunResult result : results) {
      Trace trace = result.trace();
      for (int i = trace.firstOnEdge(); i < trace.size(); i++) {
        most = Math.max(most, Math.hypot(trace.xM(i), trace.zM(i)));
      }
    }
    return most;
  }

  private void rings() {
    for (double ring : radius.ticks()) {
      svg.circle(CENTRE, radius.share(ring) * RADIUS, ring < radius.high() ? "ring" : "rim", "");
    }
    svg.words(spot(RADIUS + BEYOND + 6, 0), "middle", "0°");
    svg.words(new Spot(SIZE - 4, CENTRE.y() + 5), "end", "90°");
    svg.words(spot(-RADIUS - BEYOND + 10, 0), "middle", "180°");
    svg.words(new Spot(4, CENTRE.y() + 5), "start", "270°");
    svg.words(new Spot(SIZE - 2, 14), "end", "rings " + radius.label(radius.step()) + " m");
    svg.words(new Spot(SIZE - 2, 31), "end", "rim " + radius.label(radius.high()) + " m");
  }

  private static Spot spot(double down, double right) {
    return new Spot(CENTRE.x() + right, CENTRE.y() + down);
  }

  private void body() {
    StringBuilder path = new StringBuilder();
    for (Point corner : type.outline().corners()) {
      Spot at = place(corner.xM(), corner.zM());
      path.append(path.isEmpty() ? "M" : "L").append(Svg.at(at.x(), at.y()));
    }
    if (!path.isEmpty()) {
      svg.path(path + "Z", "body", "");
    }
  }

  private List<Spot> places(Trace trace) {
    return IntStream.range(trace.firstOnEdge(), trace.size())
        .mapToObj(i -> place(trace.xM(i), trace.zM(i)))
        .toList();
  }

  private List<Spot> edge() {
    ThresholdTable table = type.thresholds().table();
    List<Spot> edge = new ArrayList<>();
    for (int i = 0; i <= table.size(); i++) {
      int row = i % table.size();
      double bearing = table.bearingRad(row);
      double thresholdM = table.valueM(row);
      edge.add(place(thresholdM * Math.sin(bearing), thresholdM * Math.cos(bearing)));
    }
    return edge;
  }

  private Spot place(double xM, double zM) {
    double pixels = RADIUS / radius.high();
    return spot(zM * pixels, xM * pixels);
  }
}
