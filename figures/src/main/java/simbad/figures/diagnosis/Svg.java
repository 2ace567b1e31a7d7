package simbad.figures.diagnosis;

import java.math.BigDecimal;
import java.math.RoundingMode;
import simbad.figures.markup.Markup;

/** A picture in the page: shapes get their colours from the page's style sheet by class. */
final class Svg {
  private final StringBuilder text = new StringBuilder();

  /**
   * Begins a picture.
   *
   * @param width in its own units, which are pixels when it is not scaled
   * @param height likewise
   * @param title what it shows, for those who cannot see it
   */
  Svg(int width, int height, String title) {
    text.append(
        "<svg viewBox=\"0 0 "
            + width
            + " "
            + height
            + "\" role=\"img\" aria-label=\""
            + Markup.escaped(title)
            + "\">\n");
  }

  void line(double x1, double y1, double x2, double y2, String style) {
    add("<path class=\"" + style + "\" d=\"M" + at(x1, y1) + "L" + at(x2, y2) + "\"/>");
  }

  void rectangle(double x, double y, double width, double height, String style, String tip) {
    add(
        "<rect class=\""
            + style
            + "\" x=\""
            + number(x)
            + "\" y=\""
            + number(y)
            + "\" width=\""
            + number(Math.max(0, width))
            + "\" height=\""
            + number(Math.max(0, height))
            + "\">"
            + title(tip)
            + "</rect>");
  }

  void path(String d, String style, String tip) {
    add("<path class=\"" + style + "\" d=\"" + d + "\">" + title(tip) + "</path>");
  }

  void circle(double x, double y, double radius, String style) {
    add(
        "<circle class=\""
            + style
            + "\" cx=\""
            + number(x)
            + "\" cy=\""
            + number(y)
            + "\" r=\""
            + number(radius)
            + "\"/>");
  }

  /**
   * Writes words.
   *
   * @param anchor start, middle or end: what of the words stands at x
   */
  void words(double x, double y, String anchor, String words) {
    add(
        "<text x=\""
            + number(x)
            + "\" y=\""
            + number(y)
            + "\" text-anchor=\""
            + anchor
            + "\">"
            + Markup.escaped(words)
            + "</text>");
  }

  /** Writes words that stand upright along the y axis. */
  void wordsUpward(double x, double y, String words) {
    add(
        "<text transform=\"translate("
            + at(x, y)
            + ") rotate(-90)\" text-anchor=\"middle\">"
            + Markup.escaped(words)
            + "</text>");
  }

  String end() {
    return text + "</svg>\n";
  }

  private void add(String element) {
    text.append(element).append('\n');
  }

  private static String title(String tip) {
    return tip.isEmpty() ? "" : "<title>" + Markup.escaped(tip) + "</title>";
  }

  static String at(double x, double y) {
    return number(x) + " " + number(y);
  }

  static String number(double value) {
    return new BigDecimal(value)
        .setScale(2, RoundingMode.HALF_EVEN)
        .stripTrailingZeros()
        .toPlainString();
  }
}
