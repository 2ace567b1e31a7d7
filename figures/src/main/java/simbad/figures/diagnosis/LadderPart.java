package simbad.figures.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Graph;
import simbad.figures.page.Html;
import simbad.figures.page.Numbers;
import simbad.figures.page.Page;
import simbad.figures.page.PagePicture;
import simbad.figures.page.Svg;
import simbad.figures.page.Table;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.locate.PlacementOffset;
import simbad.gap.locate.PlacementOffsets;
import simbad.sonar.ping.PingLog;

/**
 * What a page says of a ladder: a log of a sensor that always looked straight at one target, from
 * places along one line. Its picture is how far readings are off, by distance; a plan would be a
 * strip.
 */
final class LadderPart {
  private static final double CM = 100;

  /** Degrees from the axis, and of bearings from each other, that still are one line. */
  private static final double ONE_LINE_DEG = 1;

  /** So many dots are told apart. */
  private static final int MOST_DOTS = 800;

  /** Labels below nought need room. */
  private static final Graph.Frame FRAME = new Graph.Frame(70, 12, 326, 188);

  private final List<RowFinding> rows;
  private final List<PlacementOffset> offsets;

  private LadderPart(List<RowFinding> rows, List<PlacementOffset> offsets) {
    this.rows = rows;
    this.offsets = offsets;
  }

  private static OptionalDouble metres(RowFinding.Fit fit) {
    OptionalDouble cm = fit.fromMeanCm();
    return cm.isEmpty() ? cm : OptionalDouble.of(cm.getAsDouble() / CM);
  }

  /**
   * Returns the part of a data set that is a ladder; of any other data set an empty one.
   *
   * @param data the rows
   * @param rows all of them, in the order of their {@link PingLog}
   */
  static LadderPart of(DataSet data, List<RowFinding> rows) {
    return new LadderPart(
        rows,
        isOneLine(rows)
            ? PlacementOffsets.of(
                data.setup(),
                new PingLog(data.readings()),
                rows.stream().map(row -> metres(row.before())).toList(),
                rows.stream().map(row -> metres(row.after())).toList())
            : List.of());
  }

  /** How far each placement is off, by distance; none where the data set is no ladder. */
  List<PlacementOffset> offsets() {
    return offsets;
  }

  private static boolean isOneLine(List<RowFinding> rows) {
    double first = rows.get(0).bearingDeg();
    return rows.stream()
        .allMatch(
            row ->
                row.obstacle() == rows.get(0).obstacle()
                    && row.offAxisDeg().orElse(180) <= ONE_LINE_DEG
                    && Math.abs(Math.IEEEremainder(row.bearingDeg() - first, 360)) <= ONE_LINE_DEG);
  }

  /** Whether the data set is no ladder. */
  boolean isEmpty() {
    return offsets.isEmpty();
  }

  /** Says which placements are off, and why there is no plan. */
  void say(Page page) {
    offsets.stream().filter(PlacementOffset::isOff).forEach(one -> page.note(sentence(one) + "."));
    page.soft(
        "All readings were taken along one line, straight at one target: seen from above they are a"
            + " strip, so there is no plan. Nothing can be said of the side or of the angle.");
  }

  /** One that is off alone, without its full stop. */
  static String sentence(PlacementOffset one) {
    double cm = CM * one.afterM();
    double half = CM * one.halfM();
    return String.format(
        Locale.ROOT,
        "placement %s at %.2f m reads %.1f cm too %s (95 %% interval %.1f to %.1f cm), far from all"
            + " other placements: measure again where it was",
        one.label(),
        one.distanceM(),
        Math.abs(cm),
        cm > 0 ? "long" : "short",
        Math.max(0, Math.abs(cm) - half),
        Math.abs(cm) + half);
  }

  /** The main picture. */
  PagePicture picture() {
    PagePicture plain =
        new PagePicture(
            "Residuals by distance",
            draw(),
            "How much too long readings are, as the simulator is. Each large dot is the middle of a"
                + " placement, its line the 95 % interval, small dots are readings. Blue line: what"
                + " the diagnosed model adds to the simulator. Dashed: no difference."
                + (offsets.stream().anyMatch(PlacementOffset::isOff)
                    ? " In a circle: off by itself."
                    : ""));
    return plain.with("By placement, as a table", table());
  }

  private Table table() {
    Table table =
        Table.of(
            "placement",
            "#distance, m",
            "#echoes",
            "#too long before, cm",
            "#too long after, cm",
            "#95\u00a0% interval",
            "");
    for (PlacementOffset one : offsets) {
      table.row(
          one.label(),
          Numbers.fixed(one.distanceM(), 2),
          one.rows(),
          Numbers.fixed(CM * one.beforeM(), 2),
          Numbers.fixed(CM * one.afterM(), 2),
          Numbers.fixed(CM * one.after95().low(), 2)
              + " to "
              + Numbers.fixed(CM * one.after95().high(), 2),
          one.isOff() ? "off by itself" : "");
    }
    return table;
  }

  private Html draw() {
    List<Double> heights = new ArrayList<>(List.of(0.0));
    for (PlacementOffset one : offsets) {
      heights.add(CM * (one.beforeM() + one.halfM()));
      heights.add(CM * (one.beforeM() - one.halfM()));
      heights.add(CM * added(one));
    }
    double most = offsets.get(offsets.size() - 1).distanceM();
    Graph graph =
        new Graph(
            new Svg(Graph.WIDTH, Graph.HEIGHT, "Residuals by distance"),
            FRAME,
            AxisScale.over(Math.min(0, offsets.get(0).distanceM()), most, 6),
            AxisScale.over(
                heights.stream().mapToDouble(h -> h).min().orElse(0),
                heights.stream().mapToDouble(h -> h).max().orElse(1),
                5));
    graph.axes("distance that the simulator expects, m", "reading too long by, cm");
    graph.level(0, "floor");
    dots(graph);
    curve(graph);
    offsets.forEach(one -> mean(graph, one));
    return graph.html();
  }

  /** Each reading at its placement's distance. */
  private void dots(Graph graph) {
    long count = rows.stream().filter(row -> row.before().fromMeanCm().isPresent()).count();
    if (count > MOST_DOTS) {
      return;
    }
    for (PlacementOffset one : offsets) {
      for (int ping : one.pings()) {
        double cm = rows.get(ping).before().fromMeanCm().orElse(0);
        graph.svg().circle(graph.spot(one.distanceM(), cm), 1.5, "ring", "");
      }
    }
  }

  private void curve(Graph graph) {
    StringBuilder path = new StringBuilder();
    for (PlacementOffset one : offsets) {
      Svg.Spot spot = graph.spot(one.distanceM(), CM * added(one));
      path.append(path.isEmpty() ? "M" : "L").append(Svg.at(spot.x(), spot.y()));
    }
    graph.svg().path(path.toString(), "moves", "");
  }

  private static void mean(Graph graph, PlacementOffset one) {
    double cm = CM * one.beforeM();
    double half = CM * one.halfM();
    graph
        .svg()
        .line(
            graph.spot(one.distanceM(), cm - half), graph.spot(one.distanceM(), cm + half), "seen");
    String tip =
        one.label()
            + ", "
            + Numbers.fixed(one.distanceM(), 2)
            + " m, "
            + one.rows()
            + " echoes: before "
            + Numbers.fixed(cm, 2)
            + " cm, after "
            + Numbers.fixed(CM * one.afterM(), 2)
            + " cm";
    Svg.Spot spot = graph.spot(one.distanceM(), cm);
    graph.svg().circle(spot, 3.5, "before", tip);
    if (one.isOff()) {
      graph.svg().circle(spot, 8, "seen", "");
    }
  }

  /** What the diagnosed model adds to the simulator's reading there, metres. */
  private static double added(PlacementOffset one) {
    return one.beforeM() - one.afterM();
  }
}
