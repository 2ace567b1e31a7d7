package simbad.figures.page;

import java.util.BitSet;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import simbad.figures.markup.Corners;
import simbad.figures.markup.Markup;
import simbad.sonar.check.Checks;

/**
 * A drawing in a page: shapes get their colours from the page's style sheet by class. What a shape
 * has for a tip is shown when it is pointed at, and read by those who go through it with the keys.
 */
public final class Svg {
  /** Of a pixel: what a curve's corners are rounded to, so that it can be enlarged. */
  private static final double FINE = 20;

  private final int width;
  private final int height;
  private final String title;
  private final Map<String, String> data = new TreeMap<>();
  private final StringBuilder text = new StringBuilder();

  /**
   * Begins a drawing.
   *
   * @param width in its own units, which are pixels when it is not scaled
   * @param height likewise
   * @param title what it shows, for those who cannot see it
   */
  public Svg(int width, int height, String title) {
    this.width = width;
    this.height = height;
    this.title = title;
  }

  /**
   * A place in a drawing.
   *
   * @param x to the right
   * @param y downward
   */
  public record Spot(double x, double y) {
    /** Checks that both are finite. */
    public Spot {
      Checks.finite("x", x);
      Checks.finite("y", y);
    }
  }

  /**
   * Says something of the drawing to the page's script.
   *
   * @param name of the data attribute
   * @param value of it
   */
  public Svg tell(String name, String value) {
    data.put(name, value);
    return this;
  }

  /**
   * Says that a table's rows are read by pointing along the x axis.
   *
   * @param table its name in the page; the first column is the place on the axis
   * @param from where the axis begins, and its value there
   * @param to where it ends, and its value there
   */
  public Svg readAlong(String table, Spot from, Spot to) {
    tell("rows", table).tell("from", plain(from.x()) + " " + plain(from.y()));
    return tell("to", plain(to.x()) + " " + plain(to.y()));
  }

  /**
   * Says that a table's rows are read by pointing round a centre.
   *
   * @param table its name in the page; the first column is the bearing in degrees
   * @param centre of the plan view
   * @param radius how far from it
   */
  public Svg readRound(String table, Spot centre, double radius) {
    return tell("rows", table)
        .tell("centre", at(centre.x(), centre.y()))
        .tell("radius", number(radius));
  }

  private static String plain(double value) {
    return Numbers.plain(value, 6);
  }

  /** Draws a straight line. */
  public void line(Spot from, Spot to, String style) {
    path("M" + at(from.x(), from.y()) + "L" + at(to.x(), to.y()), style, "");
  }

  /**
   * Draws an upright rectangle.
   *
   * @param corner its upper left one
   * @param size to the right and downward; less than nothing is nothing
   * @param style its class
   * @param tip may be empty
   */
  public void rectangle(Spot corner, Spot size, String style, String tip) {
    shape(
        "rect",
        style,
        " x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\""
            .formatted(
                number(corner.x()),
                number(corner.y()),
                number(Math.max(0, size.x())),
                number(Math.max(0, size.y()))),
        tip);
  }

  /**
   * Draws what a path describes.
   *
   * @param d as SVG has it
   * @param style its class
   * @param tip may be empty
   */
  public void path(String d, String style, String tip) {
    shape("path", style, " d=\"" + d + "\"", tip);
  }

  /**
   * Draws a curve with many corners in few bytes: corners that move it by less than a tolerance are
   * left out.
   *
   * @param corners in their order
   * @param most how many may be left; the tolerance grows until there are no more
   * @param style its class
   */
  public void curve(List<Spot> corners, int most, String style) {
    if (!corners.isEmpty()) {
      text.append("<g transform=\"scale(").append(Numbers.plain(1 / FINE, 4)).append(")\">");
      path(polyline(thinned(corners, most)), style, "");
      text.append("</g>\n");
    }
  }

  private static List<Spot> thinned(List<Spot> corners, int most) {
    double[] x = corners.stream().mapToDouble(Spot::x).toArray();
    double[] y = corners.stream().mapToDouble(Spot::y).toArray();
    double tolerance = 2 / FINE;
    BitSet kept = Corners.needed(x, y, tolerance);
    while (kept.cardinality() > most) {
      tolerance *= 1.5;
      kept = Corners.needed(x, y, tolerance);
    }
    return kept.stream().mapToObj(corners::get).toList();
  }

  /**
   * Draws cells of a square grid as rows of one colour.
   *
   * @param corner the grid's upper left one
   * @param side of a cell
   * @param rows each as M, first column, row, h and how many columns
   * @param style its class
   * @param tip may be empty
   */
  public void cells(Spot corner, double side, String rows, String style, String tip) {
    // A row's colour lies to both sides of its line.
    text.append("<g transform=\"translate(").append(at(corner.x(), corner.y() + side / 2));
    text.append(") scale(").append(Numbers.plain(side, 4)).append(")\">");
    path(rows, "cells " + style, tip);
    text.append("</g>\n");
  }

  /** Whole numbers, each from the one before, so that what is rounded does not add up. */
  private static String polyline(List<Spot> corners) {
    StringBuilder d = new StringBuilder("M");
    long x = 0;
    long y = 0;
    for (Spot corner : corners) {
      long nextX = Math.round(corner.x() * FINE);
      long nextY = Math.round(corner.y() * FINE);
      boolean isFirst = d.length() == 1;
      if (isFirst || nextX != x || nextY != y) {
        d.append(isFirst ? "" : "l").append(nextX - x);
        d.append(nextY < y ? "" : " ").append(nextY - y);
      }
      x = nextX;
      y = nextY;
    }
    return d.toString();
  }

  /**
   * Draws a disc or a ring, as its class has it.
   *
   * @param centre of it
   * @param radius of it
   * @param style its class
   * @param tip may be empty
   */
  public void circle(Spot centre, double radius, String style, String tip) {
    shape(
        "circle",
        style,
        " cx=\"%s\" cy=\"%s\" r=\"%s\""
            .formatted(number(centre.x()), number(centre.y()), number(radius)),
        tip);
  }

  /**
   * Writes words.
   *
   * @param place where they stand
   * @param anchor start, middle or end: what of the words stands there
   * @param words any
   */
  public void words(Spot place, String anchor, String words) {
    text.append(
        "<text x=\"%s\" y=\"%s\" text-anchor=\"%s\">%s</text>\n"
            .formatted(number(place.x()), number(place.y()), anchor, Markup.escaped(words)));
  }

  /** Writes words that stand upright along the y axis. */
  public void wordsUpward(Spot place, String words) {
    text.append("<text transform=\"translate(" + at(place.x(), place.y()) + ") rotate(-90)\"");
    text.append(" text-anchor=\"middle\">" + Markup.escaped(words) + "</text>\n");
  }

  private void shape(String tag, String style, String attributes, String tip) {
    text.append("<" + tag + " class=\"" + style + "\"" + attributes);
    text.append(tip.isEmpty() ? "/>" : "><title>" + Markup.escaped(tip) + "</title></" + tag + ">");
    text.append('\n');
  }

  /** Returns the drawing as a piece of a page. */
  public Html html() {
    StringBuilder all = new StringBuilder("<svg viewBox=\"0 0 " + width + " " + height + "\"");
    all.append(" role=\"img\"").append(Html.attribute("aria-label", title));
    data.forEach((name, value) -> all.append(Html.attribute("data-" + name, value)));
    return Html.raw(all.append(">\n").append(text).append("</svg>\n").toString());
  }

  /** Returns a place as a path has it. */
  public static String at(double x, double y) {
    return number(x) + " " + number(y);
  }

  /** Returns a length as a drawing has it, to a tenth. */
  public static String number(double value) {
    return Numbers.plain(value, 1);
  }
}
