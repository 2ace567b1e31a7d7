package simbad.experiments.program;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import javax.imageio.ImageIO;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;
import simbad.kernel.render.PictureSource;
import simbad.kernel.render.SoftwareCamera;
import simbad.sim.World;
import simbad.sonar.format.WholeFile;

/** Takes pictures of a world from above, -z up, every so many steps. Needs no display. */
public final class Pictures {
  private static final int SIDE_PX = 600;

  private final Path folder;
  private final long every;
  private final Picture picture = new Picture(SIDE_PX, SIDE_PX);
  private int count;

  /**
   * Prepares for pictures.
   *
   * @param folder where they go; it exists
   * @param every how many steps lie between them; at least 1
   */
  public Pictures(Path folder, long every) {
    this.folder = folder;
    this.every = every;
  }

  void offer(World world, long step) throws IOException {
    if (step % every == 0) {
      take(world, step);
    }
  }

  private void take(World world, long step) throws IOException {
    Placement eye = new Placement();
    double half = world.getWorldSize() / 2;
    eye.moveTo(0, half / Math.tan(PictureSource.FIELD_OF_VIEW_RAD / 2), 0);
    eye.turnAboutY(Math.PI / 2);
    eye.turnAboutZ(-Math.PI / 2);
    SoftwareCamera camera = new SoftwareCamera(world.getStage());
    camera.take(eye, picture);
    BufferedImage image = new BufferedImage(SIDE_PX, SIDE_PX, BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, SIDE_PX, SIDE_PX, picture.argb(), 0, SIDE_PX);
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    ImageIO.write(image, "png", bytes);
    WholeFile.write(
        folder.resolve(String.format(Locale.ROOT, "step-%06d.png", step)), bytes.toByteArray());
    count++;
  }

  /** Returns how many were taken. */
  public int count() {
    return count;
  }
}
