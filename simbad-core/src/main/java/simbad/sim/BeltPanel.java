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
 * A belt from above, ahead to the right: each ray as long as it measures, red where it has a hit,
 * and round them the numbers.
 */
final class BeltPanel extends JPanel {
  private static final int SIDE = 200;
  private static final int MARGIN = 30;
  private static final double TEXT_ROOM = 26;
  private static final double HUB_SHARE = 0.2;
  private static final Color HIT = new Color(220, 60, 50);
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
    double rim = Math.min(getWidth(), getHeight()) / 2.0 - MARGIN;
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
    double share = Math.min(1, belt.getMeasurement(i) / belt.getMaxRange());
    double end = hub + share * (rim - hub);
    double cos = Math.cos(anglesRad[i]);
    double sin = Math.sin(anglesRad[i]);
    picture.setColor(belt.hasHit(i) ? HIT : getForeground());
    picture.draw(new Line2D.Double(hub * cos, -hub * sin, end * cos, -end * sin));
    double around = rim + MARGIN / 2.0;
    if (i % every(around) == 0) {
      paintText(picture, text(i), around * cos, -around * sin);
    }
  }

  /** Leaves so many numbers out that those on the circle do not run into one another. */
  private int every(double radius) {
    double roomEach = 2 * Math.PI * radius / Math.max(1, belt.getNumSensors());
    return (int) Math.ceil(TEXT_ROOM / Math.max(1, roomEach));
  }

  private String text(int i) {
    if (belt.type() == RangeSensorBelt.TYPE_BUMPER) {
      return belt.hasHit(i) ? "hit" : "-";
    }
    double range = belt.getMeasurement(i);
    return Double.isInfinite(range) ? "\u221e" : String.format(Locale.ROOT, "%.2f", range);
  }

  private static void paintText(Graphics2D picture, String text, double x, double y) {
    picture.setFont(picture.getFont().deriveFont(10f));
    FontMetrics metrics = picture.getFontMetrics();
    double left = x - metrics.stringWidth(text) / 2.0;
    double base = y + (metrics.getAscent() - metrics.getDescent()) / 2.0;
    picture.drawString(text, (float) left, (float) base);
  }
}
