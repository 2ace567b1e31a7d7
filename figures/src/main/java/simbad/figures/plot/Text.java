package simbad.figures.plot;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.font.FontRenderContext;
import java.awt.font.TextLayout;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;

/**
 * A line of text as outlines, placed by a point of its box. Outlines look the same in PNG and SVG,
 * whatever fonts the reader has.
 */
record Text(String words, Font font, Color colour) {
  /** One context for every output, so that layout does not depend on the resolution. */
  private static final FontRenderContext CONTEXT = new FontRenderContext(null, true, true);

  /** Draws with the point at the given shares of the box: (0, 0) upper left, (1, 1) lower right. */
  void draw(Graphics2D g, double x, double y, double shareX, double shareY) {
    fill(g, placed(x, y, shareX, shareY));
  }

  /** Draws centred on a point, over a white seam that keeps curves off the letters. */
  void drawWithHalo(Graphics2D g, double x, double y) {
    Shape shape = placed(x, y, 0.5, 0.5);
    g.setColor(PlotInk.PAPER);
    g.setStroke(PlotInk.HALO);
    g.draw(shape);
    fill(g, shape);
  }

  /** Draws centred on a point, reading upwards. */
  void drawUpwards(Graphics2D g, double x, double y) {
    AffineTransform turn = AffineTransform.getRotateInstance(-Math.PI / 2, x, y);
    fill(g, Paths.rounded(turn.createTransformedShape(placed(x, y, 0.5, 0.5))));
  }

  double width() {
    return box().getWidth();
  }

  /** How far the box reaches from its centre towards a bearing, 0 being down the page. */
  double reach(double bearingRad) {
    Rectangle2D box = box();
    double across = box.getWidth() * Math.abs(Math.sin(bearingRad));
    return (across + box.getHeight() * Math.abs(Math.cos(bearingRad))) / 2;
  }

  private void fill(Graphics2D g, Shape shape) {
    g.setColor(colour);
    g.fill(shape);
  }

  private Shape placed(double x, double y, double shareX, double shareY) {
    Rectangle2D box = box();
    double dx = x - box.getX() - shareX * box.getWidth();
    double dy = y - box.getY() - shareY * box.getHeight();
    return Paths.rounded(layout().getOutline(AffineTransform.getTranslateInstance(dx, dy)));
  }

  /** As wide as the ink and as high as a digit, so that labels in a row share a base line. */
  private Rectangle2D box() {
    Rectangle2D ink = layout().getBounds();
    double height = new TextLayout("0", font, CONTEXT).getBounds().getHeight();
    return new Rectangle2D.Double(ink.getX(), -height, ink.getWidth(), height);
  }

  private TextLayout layout() {
    return new TextLayout(words, font, CONTEXT);
  }

  /** Breaks words into lines of at most the given width; a longer word is cut. */
  static List<String> wrap(String words, Font font, double width) {
    List<String> lines = new ArrayList<>();
    String line = "";
    for (String word : words.strip().split("\\s+", -1)) {
      String longer = line.isEmpty() ? word : line + " " + word;
      if (!line.isEmpty() && !fits(longer, font, width)) {
        lines.add(line);
        longer = word;
      }
      line = cut(longer, font, width, lines);
    }
    lines.add(line);
    return lines;
  }

  /** Moves what fits of a single overlong word into the lines and gives back the rest. */
  private static String cut(String line, Font font, double width, List<String> lines) {
    String rest = line;
    while (rest.length() > 1 && !fits(rest, font, width)) {
      int end = rest.length() - 1;
      while (end > 1 && !fits(rest.substring(0, end), font, width)) {
        end--;
      }
      lines.add(rest.substring(0, end));
      rest = rest.substring(end);
    }
    return rest;
  }

  private static boolean fits(String words, Font font, double width) {
    return new TextLayout(words, font, CONTEXT).getBounds().getWidth() <= width;
  }
}
