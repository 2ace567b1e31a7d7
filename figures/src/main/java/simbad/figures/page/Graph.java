package simbad.figures.page;

import simbad.figures.page.Svg.Spot;
import simbad.sonar.check.Checks;

/** The frame of a graph in a drawing: two axes, and where values lie in it. */
public final class Graph {
  /** The usual width of a drawing with a graph. */
  public static final int WIDTH = 420;

  /** The usual height. */
  public static final int HEIGHT = 250;

  private static final Frame USUAL = new Frame(58, 12, 338, 188);

  private final Svg svg;
  private final Frame frame;
  private final ChartAxis x;
  private final ChartAxis y;

  /**
   * Where the graph lies in its drawing.
   *
   * @param left its left side
   * @param top its upper side
   * @param width to the right
   * @param height downward
   */
  public record Frame(double left, double top, double width, double height) {
    /** Checks that all are finite. */
    public Frame {
      Checks.finite("left", left);
      Checks.finite("top", top);
      Checks.finite("width", width);
      Checks.finite("height", height);
    }

    /** Returns its right side. */
    public double right() {
      return left + width;
    }

    /** Returns its lower side. */
    public double bottom() {
      return top + height;
    }
  }

  /**
   * Lays a graph out in a part of a drawing.
   *
   * @param svg into which it is drawn
   * @param frame where
   * @param x to the right
   * @param y upward
   */
  public Graph(Svg svg, Frame frame, ChartAxis x, ChartAxis y) {
    this.svg = svg;
    this.frame = frame;
    this.x = x;
    this.y = y;
  }

  /**
   * Lays a graph out in a drawing of its own of the usual size.
   *
   * @param title what it shows
   * @param x to the right
   * @param y upward
   */
  public Graph(String title, ChartAxis x, ChartAxis y) {
    this(new Svg(WIDTH, HEIGHT, title), USUAL, x, y);
  }

  /** Returns what it is drawn into. */
  public Svg svg() {
    return svg;
  }

  /** Draws what lies behind the data, with a title at each side. */
  public void axes(String xTitle, String yTitle) {
    rows(yTitle);
    for (double tick : x.ticks()) {
      svg.line(
          new Spot(xOf(tick), frame.bottom()), new Spot(xOf(tick), frame.bottom() + 4), "axis");
      svg.words(new Spot(xOf(tick), frame.bottom() + 18), "middle", x.label(tick));
    }
    svg.words(new Spot(frame.left() + frame.width() / 2, frame.bottom() + 42), "middle", xTitle);
  }

  /** Draws what lies behind the data where the x axis is that of another graph below. */
  public void rows(String yTitle) {
    for (double tick : y.ticks()) {
      level(tick, "grid");
      svg.words(new Spot(frame.left() - 6, yOf(tick) + 4), "end", y.label(tick));
    }
    svg.wordsUpward(new Spot(14, frame.top() + frame.height() / 2), yTitle);
  }

  /** Draws lines upward at the x axis's ticks. */
  public void columns() {
    x.ticks().forEach(tick -> upright(tick, "grid"));
  }

  /** Draws a line upward at a value of the x axis. */
  public void upright(double value, String style) {
    svg.line(new Spot(xOf(value), frame.top()), new Spot(xOf(value), frame.bottom()), style);
  }

  /**
   * Draws a bar from the axis up.
   *
   * @param from value of its left side
   * @param to value of its right side
   * @param value how high
   * @param style its class
   * @param tip may be empty
   */
  public void bar(double from, double to, double value, String style, String tip) {
    double left = xOf(from);
    double top = yOf(value);
    svg.rectangle(new Spot(left, top), new Spot(xOf(to) - left, frame.bottom() - top), style, tip);
  }

  /** Draws a band over the whole height. */
  public void band(double from, double to, String style, String tip) {
    double left = xOf(from);
    svg.rectangle(
        new Spot(left, frame.top()), new Spot(xOf(to) - left, frame.height()), style, tip);
  }

  /** Draws a level line across. */
  public void level(double value, String style) {
    svg.line(new Spot(frame.left(), yOf(value)), new Spot(frame.right(), yOf(value)), style);
  }

  /** Draws the x axis over the data. */
  public void base() {
    svg.line(
        new Spot(frame.left(), frame.bottom()), new Spot(frame.right(), frame.bottom()), "axis");
  }

  /** Draws the x axis over the data and returns the drawing. */
  public Html html() {
    base();
    return svg.html();
  }

  /** Returns where a pair of values lies; what is beyond the y axis lies at its end. */
  public Spot spot(double xValue, double yValue) {
    return new Spot(xOf(xValue), yOf(yValue));
  }

  private double xOf(double value) {
    return frame.left() + x.share(value) * frame.width();
  }

  private double yOf(double value) {
    return frame.bottom() - Math.max(0, Math.min(1, y.share(value))) * frame.height();
  }
}
