package simbad.figures.diagnosis;

/** The frame of a graph: two axes with ticks, labels and titles, and where values lie in it. */
final class Graph {
  private static final int WIDTH = 420;
  private static final int HEIGHT = 250;
  private static final int LEFT = 58;
  private static final int RIGHT = 396;
  private static final int TOP = 12;
  private static final int BOTTOM = 200;

  private final Svg svg;
  private final AxisScale x;
  private final AxisScale y;

  Graph(String title, AxisScale x, AxisScale y) {
    this.x = x;
    this.y = y;
    svg = new Svg(WIDTH, HEIGHT, title);
  }

  /** Draws what lies behind the data. */
  void axes(String xTitle, String yTitle) {
    for (double tick : y.ticks()) {
      svg.line(LEFT, yOf(tick), RIGHT, yOf(tick), "grid");
      svg.words(LEFT - 6, yOf(tick) + 4, "end", y.label(tick));
    }
    for (double tick : x.ticks()) {
      svg.line(xOf(tick), BOTTOM, xOf(tick), BOTTOM + 4, "axis");
      svg.words(xOf(tick), BOTTOM + 18, "middle", x.label(tick));
    }
    svg.words((LEFT + RIGHT) / 2.0, HEIGHT - 8, "middle", xTitle);
    svg.wordsUpward(14, (TOP + BOTTOM) / 2.0, yTitle);
  }

  /** Draws a bar from the axis up. */
  void bar(double from, double to, double value, String style, String tip) {
    double left = xOf(from);
    svg.rectangle(left, yOf(value), xOf(to) - left, yOf(y.low()) - yOf(value), style, tip);
  }

  /** Draws a level line across. */
  void level(double value, String style) {
    svg.line(LEFT, yOf(value), RIGHT, yOf(value), style);
  }

  /** Draws the x axis over the bars and ends the picture. */
  String end() {
    svg.line(LEFT, BOTTOM, RIGHT, BOTTOM, "axis");
    return svg.end();
  }

  private double xOf(double value) {
    return LEFT + x.share(value) * (RIGHT - LEFT);
  }

  private double yOf(double value) {
    return BOTTOM - Math.max(0, Math.min(1, y.share(value))) * (BOTTOM - TOP);
  }
}
