package simbad.sim;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.util.List;
import javax.swing.JPanel;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.geometry.CylinderShape;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;

/**
 * A sensor that sees the world in colour, 45 degrees wide. The image is that of the update: it
 * shows the world as it was at the start of that step. Before the first update it is black.
 */
public class Eye extends SensorDevice {
  private static final Rgb HOUSING = new Rgb(0.3f, 0.3f, 0.3f);

  /** The latest image's pixels, row by row from the top, each 0xAARRGGBB; to be read only. */
  protected int[] tempRGBABuffer;

  /** Columns of the image; to be read only. */
  protected int imageWidth;

  /** Rows of the image; to be read only. */
  protected int imageHeight;

  private final Picture picture;
  private final Picture taken;
  private final Placement worldFromEye = new Placement();
  private final float radius;

  Eye(float radius, int width, int height) {
    this.radius = radius;
    imageWidth = width;
    imageHeight = height;
    picture = new Picture(width, height);
    taken = new Picture(width, height);
    tempRGBABuffer = picture.argb();
  }

  /** Returns the housing; the eye inside it does not see it. */
  @Override
  protected List<Facets> drawing() {
    return List.of(Facets.lit(new CylinderShape(radius, radius), HOUSING));
  }

  /** Returns a new black image into which this eye's image can be copied. */
  public final BufferedImage createCompatibleImage() {
    return new BufferedImage(imageWidth, imageHeight, BufferedImage.TYPE_INT_RGB);
  }

  /** Returns a new matrix of zeros into which this eye's image can be copied. */
  public final SensorMatrix createCompatibleSensorMatrix() {
    return world == null
        ? new SensorMatrix(imageWidth, imageHeight)
        : new SensorMatrix(
            imageWidth, imageHeight, world.restores(Compatibility.MATRIX_EDGE_THROWS));
  }

  /**
   * Copies the latest image.
   *
   * @param image gets the image; of this eye's size
   */
  public final synchronized void copyVisionImage(BufferedImage image) {
    requireSize("image", image.getWidth(), image.getHeight());
    image.setRGB(0, 0, imageWidth, imageHeight, picture.argb(), 0, imageWidth);
  }

  /**
   * Copies the latest image in gray.
   *
   * @param matrix gets each pixel's mean of red, green and blue, in [0, 1]; of this eye's size
   */
  public final synchronized void copyVisionImage(SensorMatrix matrix) {
    requireSize("matrix", matrix.getWidth(), matrix.getHeight());
    for (int row = 0; row < imageHeight; row++) {
      for (int column = 0; column < imageWidth; column++) {
        matrix.getArray()[row * imageWidth + column] = picture.gray(column, row);
      }
    }
  }

  private void requireSize(String name, int width, int height) {
    if (width != imageWidth || height != imageHeight) {
      throw new IllegalArgumentException(
          name + " = " + width + " x " + height + " is not " + imageWidth + " x " + imageHeight);
    }
  }

  /**
   * Sees. Outside a world there is nothing to see.
   *
   * <p>Whoever wants the image meanwhile gets the former one and need not wait: Java 3D opens a
   * frame for its first picture and so waits for the event thread, which may be painting this one.
   */
  @Override
  protected void update() {
    if (world != null) {
      placeEye(worldFromEye);
      world.takePicture(worldFromEye, taken);
      keepTaken();
    }
  }

  private synchronized void keepTaken() {
    picture.copyFrom(taken);
  }

  /** Computes where the eye looks from. */
  void placeEye(Placement placement) {
    placeInWorld(placement);
  }

  /** Returns the latest image, for those in this package. */
  Picture picture() {
    return picture;
  }

  /** Forgets the image. */
  @Override
  protected void reset() {
    synchronized (this) {
      picture.clear();
    }
  }

  /** Returns a panel that shows the image. */
  @Override
  public JPanel createInspectorPanel() {
    return new EyeJPanel();
  }

  /** Returns the columns of the image. */
  public int getImageWidth() {
    return imageWidth;
  }

  /** Returns the rows of the image. */
  public int getImageHeight() {
    return imageHeight;
  }

  /** Shows the image. */
  public class EyeJPanel extends JPanel {
    private static final int MARGIN_PX = 5;

    private final transient BufferedImage image = createCompatibleImage();

    /** Creates a panel. */
    public EyeJPanel() {
      setPreferredSize(new Dimension(imageWidth + 2 * MARGIN_PX, imageHeight + 2 * MARGIN_PX));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
      super.paintComponent(graphics);
      copyVisionImage(image);
      graphics.drawImage(image, MARGIN_PX, MARGIN_PX, null);
      graphics.setColor(Color.DARK_GRAY);
      graphics.drawRect(MARGIN_PX - 1, MARGIN_PX - 1, imageWidth + 1, imageHeight + 1);
    }
  }
}
