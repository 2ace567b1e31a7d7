package simbad.scene3d;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.GraphicsEnvironment;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import javax.media.j3d.Appearance;
import javax.media.j3d.GeometryArray;
import javax.media.j3d.ImageComponent;
import javax.media.j3d.ImageComponent2D;
import javax.media.j3d.QuadArray;
import javax.media.j3d.RenderingAttributes;
import javax.media.j3d.Shape3D;
import javax.media.j3d.Texture;
import javax.media.j3d.Texture2D;
import javax.media.j3d.TextureAttributes;
import javax.media.j3d.TransparencyAttributes;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import javax.vecmath.TexCoord2f;

/**
 * Text on a plate, light on dark, so that it can be read before anything. One unit of it is a
 * pixel; its lower edge is level with its frame's middle.
 */
final class TagShape {
  private static final Font FONT = new Font(Font.SANS_SERIF, Font.BOLD, 12);
  private static final Color PLATE = new Color(20, 24, 30, 200);
  private static final int PADDING_PX = 5;
  private static final int ROUND_PX = 8;

  private TagShape() {}

  static Shape3D of(String text) {
    int fineness = fineness();
    FontMetrics metrics = metrics();
    int width = metrics.stringWidth(text) + 2 * PADDING_PX;
    int height = metrics.getHeight() + 2;
    BufferedImage image =
        new BufferedImage(
            powerOf2(fineness * width), powerOf2(fineness * height), BufferedImage.TYPE_INT_ARGB);
    Graphics2D graphics = image.createGraphics();
    graphics.scale(fineness, fineness);
    paint(graphics, text, width, height);
    graphics.dispose();
    return new Shape3D(plate(image, width, height, fineness), appearance(image));
  }

  /** As many pixels of the image as the screen has for one of the layout's. */
  private static int fineness() {
    double scale =
        GraphicsEnvironment.getLocalGraphicsEnvironment()
            .getDefaultScreenDevice()
            .getDefaultConfiguration()
            .getDefaultTransform()
            .getScaleX();
    return Math.max(1, (int) Math.ceil(scale));
  }

  private static FontMetrics metrics() {
    Graphics2D graphics = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB).createGraphics();
    FontMetrics metrics = graphics.getFontMetrics(FONT);
    graphics.dispose();
    return metrics;
  }

  private static int powerOf2(int least) {
    return least <= 1 ? 1 : 2 * Integer.highestOneBit(least - 1);
  }

  private static void paint(Graphics2D graphics, String text, int width, int height) {
    graphics.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    graphics.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    graphics.setColor(PLATE);
    graphics.fillRoundRect(0, 0, width, height, ROUND_PX, ROUND_PX);
    graphics.setColor(Color.WHITE);
    graphics.setFont(FONT);
    graphics.drawString(text, PADDING_PX, 1 + graphics.getFontMetrics().getAscent());
  }

  /** The part of the image that is painted, which is its upper left corner. */
  private static QuadArray plate(BufferedImage image, int width, int height, int fineness) {
    float right = (float) fineness * width / image.getWidth();
    float bottom = 1 - (float) fineness * height / image.getHeight();
    QuadArray quad =
        new QuadArray(4, GeometryArray.COORDINATES | GeometryArray.TEXTURE_COORDINATE_2);
    double half = width / 2.0;
    double[] x = {-half, half, half, -half};
    double[] y = {0, 0, height, height};
    float[] s = {0, right, right, 0};
    float[] t = {bottom, bottom, 1, 1};
    for (int i = 0; i < x.length; i++) {
      quad.setCoordinate(i, new Point3d(x[i], y[i], 0));
      quad.setTextureCoordinate(0, i, new TexCoord2f(s[i], t[i]));
    }
    return quad;
  }

  private static Appearance appearance(BufferedImage image) {
    Texture2D texture =
        new Texture2D(Texture.BASE_LEVEL, Texture.RGBA, image.getWidth(), image.getHeight());
    texture.setImage(0, new ImageComponent2D(ImageComponent.FORMAT_RGBA, image));
    texture.setMinFilter(Texture.BASE_LEVEL_LINEAR);
    texture.setMagFilter(Texture.BASE_LEVEL_LINEAR);
    Appearance appearance = Appearances.unlit(new Color3f(1, 1, 1));
    appearance.setTexture(texture);
    TextureAttributes asItIs = new TextureAttributes();
    asItIs.setTextureMode(TextureAttributes.REPLACE);
    appearance.setTextureAttributes(asItIs);
    appearance.setTransparencyAttributes(
        new TransparencyAttributes(TransparencyAttributes.BLENDED, 0));
    RenderingAttributes beforeAll = new RenderingAttributes();
    beforeAll.setDepthBufferEnable(false);
    beforeAll.setDepthBufferWriteEnable(false);
    appearance.setRenderingAttributes(beforeAll);
    return appearance;
  }
}
