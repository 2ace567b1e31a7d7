package simbad.figures.blindcheck;

import java.util.List;
import simbad.figures.page.AxisScale;
import simbad.figures.page.Graph;
import simbad.figures.page.Html;
import simbad.figures.page.Svg;
import simbad.figures.page.Svg.Spot;

/**
 * What was claimed, to the right, against what was found, upward, on one scale: points on the
 * diagonal were claimed rightly. A reliability diagram is one (Murphy and Winkler 1977, Applied
 * Statistics 26, 41). Points beyond the scale are drawn at its edge.
 */
final class AgreementGraph {
  private static final int WIDTH = 420;
  private static final int HEIGHT = 400;
  private static final Graph.Frame FRAME = new Graph.Frame(58, 12, 338, 338);
  private static final double DOT = 4;
  private static final double STEP = 0.2;

  private final Svg svg;
  private final AxisScale scale;
  private final Graph graph;

  /**
   * Begins a picture.
   *
   * @param title what it shows
   * @param claimed title of the axis to the right
   * @param found title of the axis upward
   * @param least where both axes begin, a multiple of 0.2; they end at 1
   */
  AgreementGraph(String title, String claimed, String found, double least) {
    svg = new Svg(WIDTH, HEIGHT, title);
    scale = new AxisScale(least, 1, STEP);
    graph = new Graph(svg, FRAME, scale, scale);
    graph.columns();
    graph.axes(claimed, found);
    svg.line(graph.spot(least, least), graph.spot(1, 1), "floor");
  }

  /**
   * Draws a group of claims.
   *
   * @param claimed what they state in the mean
   * @param found what was so
   * @param low lower end of the interval of that
   * @param high its upper end
   * @param tip the same in words
   */
  void group(double claimed, double found, double low, double high, String tip) {
    svg.line(spot(claimed, low), spot(claimed, high), "whisker");
    svg.circle(spot(claimed, found), DOT, "after", tip);
  }

  /** Draws single claims as one shape: of a large check they would fill the page. */
  void cloud(List<Spot> claims, String tip) {
    if (claims.isEmpty()) {
      return;
    }
    StringBuilder d = new StringBuilder();
    claims.stream()
        .map(claim -> spot(claim.x(), claim.y()))
        .map(place -> "M" + Svg.at(place.x(), place.y()) + "h0")
        .distinct()
        .forEach(d::append);
    svg.path(d.toString(), "cloud", tip);
  }

  private Spot spot(double claimed, double found) {
    return graph.spot(Math.max(scale.low(), Math.min(scale.high(), claimed)), found);
  }

  Html html() {
    return graph.html();
  }
}
