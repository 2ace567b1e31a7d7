package simbad.sim;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.Locale;
import javax.swing.JPanel;

/**
 * A belt from above, ahead to the right: a ray with an echo is red and as long as its range, one
 * without is an orange stub as in the world; round them the ranges, or that there is none.
 */
final class BeltPanel extends JPanel {
  private static final int SIDE = 200;
  private static final int MARGIN_X = 46;
  private static final int MARGIN_Y = 20;
  private static final double TEXT_ROOM = 36;
  private static final double STUB_SHARE = 0.1;
  private static final float FONT_PX = 10;
  private static final String NO_ECHO = "no echo";
  private static final double HUB_SHARE = 0.2;
  private static final Color HIT = new Color(198, 38, 30);
  private static final Color HIT_ON_DARK = new Color(255, 120, 110);
  private static final int MIDDLE_GREY = 128;
  private static final Color SILENT = new Color(240, 128, 64);
  private static final Color RING = new Color(128, 128, 128, 80);

  private final transient RangeSensorBelt belt;
  private final double[] anglesRad;

  BeltPanel(RangeSensorBelt belt) {
    this.belt = belt;
    anglesRad = SensorBeams.anglesRad(belt.layout());
    setPreferredSize(new Dimension(SIDE, SIDE));
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    Graphics2D picture = (Graphics2D) graphics.create();
    picture.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    picture.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    picture.translate(getWidth() / 2.0, getHeight() / 2.0);
    double rim = Math.min(getWidth() / 2.0 - MARGIN_X, getHeight() / 2.0 - MARGIN_Y);
    double hub = HUB_SHARE * rim;
    paintCircle(picture, hub);
    paintCircle(picture, rim);
    for (int i = 0; i < belt.getNumSensors(); i++) {
      paintRay(picture, i, hub, rim);
    }
    picture.dispose();
  }

  private static void paintCircle(Graphics2D picture, double radius) {
    picture.setColor(RING);
    picture.draw(new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius));
  }

  private void paintRay(Graphics2D picture, int i, double hub, double rim) {
    boolean echo = belt.hasHit(i);
    double share = echo ? Math.min(1, belt.getMeasurement(i) / belt.getMaxRange()) : STUB_SHARE;
    double end = hub + share * (rim - hub);
    double cos = Math.cos(anglesRad[i]);
    double sin = Math.sin(anglesRad[i]);
    picture.setColor(echo ? hit() : SILENT);
    picture.draw(new Line2D.Double(hub * cos, -hub * sin, end * cos, -end * sin));
    double across = rim + MARGIN_X / 2.0;
    if (i % every(across) == 0) {
      picture.setColor(echo ? hit() : getForeground());
      paintText(picture, text(i), across * cos, -(rim + MARGIN_Y / 2.0) * sin);
    }
  }

  /** Red that can be read on the panel. */
  private Color hit() {
    return getBackground().getGreen() < MIDDLE_GREY ? HIT_ON_DARK : HIT;
  }

  /** Leaves so many numbers out that those on the circle do not run into one another. */
  private int every(double radius) {
    double roomEach = 2 * Math.PI * radius / Math.max(1, belt.getNumSensors());
    return (int) Math.ceil(TEXT_ROOM / Math.max(1, roomEach));
  }

  /** What is written at a sensor: what it hears, never the number that stands for nothing. */
  String text(int i) {
    if (belt.type() == RangeSensorBelt.TYPE_BUMPER) {
      return belt.hasHit(i) ? "hit" : "-";
    }
    return belt.hasHit(i) ? String.format(Locale.ROOT, "%.2f m", belt.getMeasurement(i)) : NO_ECHO;
  }

  private static void paintText(Graphics2D picture, String text, double x, double y) {
    picture.setFont(picture.getFont().deriveFont(FONT_PX));
    FontMetrics metrics = picture.getFontMetrics();
    double left = x - metrics.stringWidth(text) / 2.0;
    double base = y + (metrics.getAscent() - metrics.getDescent()) / 2.0;
    picture.drawString(text, (float) left, (float) base);
  }
}
