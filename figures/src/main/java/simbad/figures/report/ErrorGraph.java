package simbad.figures.report;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import simbad.experiments.run.Arc;
import simbad.experiments.run.RunResult;
import simbad.experiments.run.SensorKind;
import simbad.experiments.run.Trace;
import simbad.figures.page.AxisScale;
import simbad.figures.page.ChartAxis;
import simbad.figures.page.Graph;
import simbad.figures.page.Html;
import simbad.figures.page.Svg;
import simbad.figures.page.Svg.Spot;
import simbad.figures.plot.ErrorScale;
import simbad.sonar.shape.ThresholdTable;

/**
 * Errors by bearing, and above them on the same axis the table's lobes with the robots' ways over
 * them: a lobe that was cut off is one that a way passes below.
 */
final class ErrorGraph {
  private static final int WIDTH = 440;
  private static final int HEIGHT = 398;
  private static final Graph.Frame ABOVE = new Graph.Frame(60, 10, 364, 140);
  private static final Graph.Frame BELOW = new Graph.Frame(60, 172, 364, 176);
  private static final double TURN_DEG = 360;
  private static final AxisScale BEARINGS = new AxisScale(0, TURN_DEG, 45);
  private static final double CM = 100;

  private final List<RunResult> results;
  private final ThresholdTable table;
  private final ErrorScale scale;
  private final Svg svg;
  private final Graph lobes;
  private final Graph errors;

  private ErrorGraph(List<RunResult> results) {
    this.results = results;
    table = results.get(0).type().thresholds().table();
    scale = RunPictures.errorPlot(results).scale();
    svg = new Svg(WIDTH, HEIGHT, "Errors and lobes by bearing: " + results.get(0).type().name());
    lobes = new Graph(svg, ABOVE, BEARINGS, AxisScale.over(0, Math.max(reachM(), 0.1), 4));
    errors = new Graph(svg, BELOW, BEARINGS, new ErrorAxis(scale));
  }

  /**
   * Draws the graph.
   *
   * @param results of one obstacle; at least one
   * @param table name of the page's table that has a row for each bearing
   * @param most how many corners a curve may have
   */
  static Html of(List<RunResult> results, String table, int most) {
    ErrorGraph graph = new ErrorGraph(results);
    graph.svg.readAlong(table, new Spot(ABOVE.left(), 0), new Spot(ABOVE.right(), TURN_DEG));
    graph.ground();
    for (RunResult result : SensorStyle.drawn(results)) {
      graph.way(result, most);
      graph.curve(result, most);
    }
    graph.svg.curve(graph.edge(), Integer.MAX_VALUE, "table");
    graph.lobes.base();
    graph.errors.base();
    return graph.svg.html();
  }

  /** The pieces of the edge that were not kept are marked over both graphs. */
  private void ground() {
    List<Spot> area = new ArrayList<>(edge());
    area.add(lobes.spot(TURN_DEG, 0));
    area.add(lobes.spot(0, 0));
    StringBuilder path = new StringBuilder();
    for (Spot corner : area) {
      path.append(path.isEmpty() ? "M" : "L").append(Svg.at(corner.x(), corner.y()));
    }
    svg.path(path + "Z", "lobe", "");
    results.stream()
        .filter(ErrorGraph::isCut)
        .flatMap(result -> result.errors().edge().skipped().stream())
        .forEach(this::cut);
    lobes.columns();
    errors.columns();
    lobes.rows("distance, m");
    errors.axes("bearing in the table, degrees", "radial error, cm");
  }

  /** Whether parts of the edge are marked; the original sensor follows no table's edge. */
  static boolean isCut(RunResult result) {
    return !result.sensor().equals(SensorKind.ORIGINAL)
        && !result.errors().edge().skipped().isEmpty();
  }

  private void cut(Arc arc) {
    double from = Math.toDegrees(arc.fromRad());
    double to = Math.toDegrees(arc.toRad());
    if (to >= from) {
      band(from, to);
    } else {
      band(from, TURN_DEG);
      band(0, to);
    }
  }

  private void band(double from, double to) {
    lobes.band(from, to, "cut", "");
    errors.band(from, to, "cut", "");
  }

  private double reachM() {
    double most = table.greatestM();
    for (RunResult result : results) {
      Trace trace = result.trace();
      for (int i = trace.firstOnEdge(); i < trace.size(); i++) {
        most = Math.max(most, Math.hypot(trace.xM(i), trace.zM(i)));
      }
    }
    return most;
  }

  private List<Spot> edge() {
    List<Spot> edge = new ArrayList<>();
    for (int i = 0; i < table.size(); i++) {
      edge.add(lobes.spot(Math.toDegrees(table.bearingRad(i)), table.valueM(i)));
    }
    edge.add(lobes.spot(TURN_DEG, table.valueM(0)));
    return edge;
  }

  /** The way ends at one side where it comes in at the other. */
  private void way(RunResult result, int most) {
    Trace trace = result.trace();
    List<Spot> piece = new ArrayList<>();
    double before = 0;
    for (int i = trace.firstOnEdge(); i < trace.size(); i++) {
      double degrees = Math.toDegrees(Math.atan2(trace.xM(i), trace.zM(i)));
      double bearing = degrees < 0 ? degrees + TURN_DEG : degrees;
      if (!piece.isEmpty() && Math.abs(bearing - before) > TURN_DEG / 2) {
        svg.curve(piece, most, SensorStyle.of(result));
        piece.clear();
      }
      piece.add(lobes.spot(bearing, Math.hypot(trace.xM(i), trace.zM(i))));
      before = bearing;
    }
    svg.curve(piece, most, SensorStyle.of(result));
  }

  /** Bearings that were not reached leave a hole. */
  private void curve(RunResult result, int most) {
    List<Spot> piece = new ArrayList<>();
    for (int i = 0; i <= table.size(); i++) {
      int row = i % table.size();
      OptionalDouble error = result.errors().radialM().get(row);
      if (error.isPresent()) {
        double bearing = i < table.size() ? Math.toDegrees(table.bearingRad(row)) : TURN_DEG;
        piece.add(errors.spot(bearing, CM * error.getAsDouble()));
      } else {
        end(piece, most, result);
      }
    }
    end(piece, most, result);
  }

  private void end(List<Spot> piece, int most, RunResult result) {
    if (piece.size() == 1) {
      svg.circle(piece.get(0), 2, "dot", "");
    } else {
      svg.curve(piece, most, SensorStyle.of(result));
    }
    piece.clear();
  }

  /** The error's axis, straight or logarithmic. */
  private record ErrorAxis(ErrorScale scale) implements ChartAxis {
    @Override
    public double share(double cm) {
      double low = scale.bottomCm();
      double value = scale.clamped(cm);
      return scale.isLog()
          ? Math.log(value / low) / Math.log(scale.topCm() / low)
          : (value - low) / (scale.topCm() - low);
    }

    @Override
    public List<Double> ticks() {
      return scale.ticks();
    }

    @Override
    public String label(double cm) {
      return scale.label(cm);
    }
  }
}
