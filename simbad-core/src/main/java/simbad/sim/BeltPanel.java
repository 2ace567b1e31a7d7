package simbad.sim;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.util.Locale;
import javax.swing.JPanel;

/**
 * A belt from above, ahead to the right: each ray as long as it measures, red where it has a hit.
 */
final class BeltPanel extends JPanel {
  private static final int SIDE = 150;
  private static final int HUB = 20;

  private final transient RangeSensorBelt belt;

  BeltPanel(RangeSensorBelt belt) {
    this.belt = belt;
    setPreferredSize(new Dimension(SIDE, SIDE));
  }

  @Override
  protected void paintComponent(Graphics graphics) {
    super.paintComponent(graphics);
    for (int i = 0; i < belt.getNumSensors(); i++) {
      paintRay(graphics, i);
    }
  }

  private void paintRay(Graphics graphics, int i) {
    double share = Math.min(1, belt.getMeasurement(i) / belt.getMaxRange());
    double end = HUB + share * (SIDE / 2 - 2 * HUB);
    double angle = belt.getSensorAngle(i);
    graphics.setColor(belt.hasHit(i) ? Color.RED : Color.GRAY);
    graphics.drawLine(across(angle, HUB), down(angle, HUB), across(angle, end), down(angle, end));
    String text =
        belt.type() == RangeSensorBelt.TYPE_BUMPER
            ? String.valueOf(belt.hasHit(i))
            : String.format(Locale.ROOT, "%.2f", belt.getMeasurement(i));
    graphics.drawString(text, across(angle, end) - HUB / 2, down(angle, end));
  }

  private static int across(double angle, double length) {
    return (int) Math.round(SIDE / 2 + length * Math.cos(angle));
  }

  private static int down(double angle, double length) {
    return (int) Math.round(SIDE / 2 - length * Math.sin(angle));
  }
}
