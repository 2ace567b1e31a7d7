package simbad.gui;

import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Image;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.Icon;

/**
 * A robot from above, as the world shows it.
 *
 * @param sizePx side in pixels
 */
record RobotIcon(int sizePx) implements Icon {
  /** Side of the icon in a window's title. */
  static final int TITLE_PX = 16;

  private static final Color BODY = new Color(0, 170, 60);
  private static final Color NOSE = new Color(190, 30, 30);

  /** Returns the icon in the sizes that desktops ask for. */
  static List<Image> images() {
    return Stream.of(16, 32, 64, 128).map(RobotIcon::new).map(RobotIcon::image).toList();
  }

  private Image image() {
    BufferedImage image = new BufferedImage(sizePx, sizePx, BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = image.createGraphics();
    paint(graphics);
    graphics.dispose();
    return image;
  }

  private void paint(Graphics2D graphics) {
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.scale(sizePx, sizePx);
    graphics.setColor(BODY);
    graphics.fill(new Ellipse2D.Double(0.05, 0.05, 0.9, 0.9));
    Path2D nose = new Path2D.Double();
    nose.moveTo(0.5, 0.08);
    nose.lineTo(0.72, 0.5);
    nose.lineTo(0.28, 0.5);
    nose.closePath();
    graphics.setColor(NOSE);
    graphics.fill(nose);
  }

  @Override
  public void paintIcon(Component component, Graphics graphics, int x, int y) {
    Graphics2D shifted = (Graphics2D) graphics.create();
    shifted.translate(x, y);
    paint(shifted);
    shifted.dispose();
  }

  @Override
  public int getIconWidth() {
    return sizePx;
  }

  @Override
  public int getIconHeight() {
    return sizePx;
  }
}
