package simbad.figures.plot;

import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.AffineTransform;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.function.IntBinaryOperator;

/**
 * Coloured cells as one image. Cells drawn as rectangles show seams in viewers that smooth edges,
 * and fill the SVG.
 */
final class Tiles {
  /** Viewers blur an image when they enlarge it; with this many pixels the blur is not seen. */
  private static final int LEAST_PIXELS = 720;

  private Tiles() {}

  /** An image of {@code columns} by {@code rows} cells, each several pixels wide. */
  static BufferedImage image(int columns, int rows, IntBinaryOperator rgbAt) {
    int side = Math.max(1, (LEAST_PIXELS + columns - 1) / Math.max(columns, rows));
    // With an alpha channel, the SVG holds a PNG: without one it might be a lossy JPEG.
    BufferedImage image =
        new BufferedImage(columns * side, rows * side, BufferedImage.TYPE_INT_ARGB);
    for (int y = 0; y < rows * side; y++) {
      for (int x = 0; x < columns * side; x++) {
        image.setRGB(x, y, 0xFF000000 | rgbAt.applyAsInt(x / side, y / side));
      }
    }
    return image;
  }

  static void draw(Graphics2D g, BufferedImage image, Rectangle2D place) {
    AffineTransform before = g.getTransform();
    g.setRenderingHint(
        RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
    g.translate(place.getX(), place.getY());
    g.scale(place.getWidth() / image.getWidth(), place.getHeight() / image.getHeight());
    g.drawImage(image, 0, 0, null);
    g.setTransform(before);
  }
}
