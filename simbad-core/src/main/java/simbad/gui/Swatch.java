package simbad.gui;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import javax.swing.Icon;
import simbad.scene3d.Look;
import simbad.scene3d.Palette;
import simbad.scene3d.Sign;

/**
 * A sample of what a sign looks like in the world.
 *
 * @param sign what it is a sample of
 * @param dark whether the window is dark
 */
record Swatch(Sign sign, boolean dark) implements Icon {
  private static final int WIDTH = 18;
  private static final int HEIGHT = 14;
  private static final double MIDDLE = HEIGHT / 2.0;
  private static final Color SILENT = new Color(240, 128, 64);
  private static final Color ECHO = new Color(226, 40, 36);
  private static final Color SAND = new Color(222, 184, 135);
  private static final Color X_AXIS = new Color(217, 38, 26);
  private static final Color Z_AXIS = new Color(26, 77, 230);
  private static final Color RIM = new Color(128, 128, 128, 120);
  private static final BasicStroke LINE = new BasicStroke(2.2f);

  @Override
  public void paintIcon(Component component, Graphics graphics, int x, int y) {
    if (sign == Sign.ROBOT) {
      new RobotIcon(HEIGHT).paintIcon(component, graphics, x + (WIDTH - HEIGHT) / 2, y);
      return;
    }
    Graphics2D shifted = (Graphics2D) graphics.create();
    shifted.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    shifted.translate(x, y);
    shifted.setStroke(LINE);
    paint(shifted);
    shifted.dispose();
  }

  private void paint(Graphics2D graphics) {
    Palette palette = Palette.of(Look.LIGHT.withDark(dark));
    switch (sign) {
      case SILENT -> paintBeam(graphics, SILENT, 0.45);
      case ECHO -> paintBeam(graphics, ECHO, 1);
      case SHADOW -> paintSand(graphics);
      case AXES -> paintAxes(graphics);
      case EDGE -> paintLine(graphics, new Color(palette.edgeRgb()), 1);
      default -> paintLine(graphics, new Color(palette.trailRgb()), 1);
    }
  }

  private static void paintSand(Graphics2D graphics) {
    Rectangle2D patch = new Rectangle2D.Double(1, 1, WIDTH - 2, HEIGHT - 2);
    graphics.setColor(SAND);
    graphics.fill(patch);
    graphics.setColor(RIM);
    graphics.setStroke(new BasicStroke(1));
    graphics.draw(patch);
  }

  /** The x and the z axis, seen from above. */
  private static void paintAxes(Graphics2D graphics) {
    graphics.setColor(X_AXIS);
    graphics.draw(new Line2D.Double(2, 2, WIDTH - 2, 2));
    graphics.setColor(Z_AXIS);
    graphics.draw(new Line2D.Double(2, 2, 2, HEIGHT - 1));
  }

  private static void paintBeam(Graphics2D graphics, Color color, double share) {
    paintLine(graphics, color, share);
    double end = 1 + share * (WIDTH - 4);
    graphics.fill(new Ellipse2D.Double(end - 2, MIDDLE - 2.5, 5, 5));
  }

  private static void paintLine(Graphics2D graphics, Color color, double share) {
    graphics.setColor(color);
    graphics.draw(new Line2D.Double(1, MIDDLE, 1 + share * (WIDTH - 2), MIDDLE));
  }

  @Override
  public int getIconWidth() {
    return WIDTH;
  }

  @Override
  public int getIconHeight() {
    return HEIGHT;
  }
}
