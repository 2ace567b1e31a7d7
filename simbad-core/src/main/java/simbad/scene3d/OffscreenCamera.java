package simbad.scene3d;

import java.awt.GraphicsEnvironment;
import java.util.ArrayList;
import java.util.List;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.Group;
import javax.media.j3d.Locale;
import javax.media.j3d.RenderingError;
import javax.media.j3d.RenderingErrorListener;
import javax.media.j3d.Transform3D;
import javax.media.j3d.TransformGroup;
import javax.media.j3d.VirtualUniverse;
import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Stage;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;
import simbad.kernel.render.PictureSource;

/**
 * Takes pictures with Java 3D, out of sight. Its scene is its own, apart from the window's, and is
 * brought up to date by the thread that takes a picture: the picture shows the stage as it is
 * during the call. Needs a display.
 */
public final class OffscreenCamera implements PictureSource {
  private final Stage stage;
  private final VirtualUniverse universe = new VirtualUniverse();
  private final Locale locale = new Locale(universe);
  private final List<Tracked> tracked = new ArrayList<>();
  private final TransformGroup eye = new TransformGroup();
  private final List<Film> films = new ArrayList<>();
  private final double[] matrix = new double[16];
  private final RenderingErrorListener errors = this::fail;
  private volatile String failure = "";

  /** A visual with the figure that follows it, made anew when parts come. */
  private static final class Tracked {
    private final Visual visual;
    private int parts = -1;
    private @Nullable Figure figure;

    Tracked(Visual visual) {
      this.visual = visual;
    }
  }

  private OffscreenCamera(Stage stage) {
    this.stage = stage;
    build();
  }

  /**
   * Creates a camera for a stage.
   *
   * @throws DisplayException if Java 3D cannot draw here
   */
  public static OffscreenCamera open(Stage stage) {
    if (GraphicsEnvironment.isHeadless()) {
      throw Missing.display();
    }
    try {
      synchronized (UniverseLock.LOCK) {
        Film.configuration();
        return new OffscreenCamera(stage);
      }
    } catch (RuntimeException | LinkageError e) {
      throw Missing.of(e);
    }
  }

  private void build() {
    // Java 3D's own answer to an error is to end the process.
    VirtualUniverse.addRenderingErrorListener(errors);
    eye.setCapability(TransformGroup.ALLOW_TRANSFORM_WRITE);
    eye.setCapability(Group.ALLOW_CHILDREN_EXTEND);
    BranchGroup branch = new BranchGroup();
    branch.addChild(eye);
    locale.addBranchGraph(branch);
    locale.addBranchGraph(Illumination.of(stage));
  }

  private void fail(RenderingError error) {
    failure = error.getErrorMessage();
  }

  /**
   * Takes a picture.
   *
   * @throws DisplayException if Java 3D has failed
   */
  @Override
  public void take(Placement worldFromEye, Picture picture) {
    follow();
    point(worldFromEye);
    film(picture).expose(picture);
    if (!failure.isEmpty()) {
      throw Missing.openGl(failure);
    }
  }

  private void follow() {
    for (int i = tracked.size(); i < stage.visuals().size(); i++) {
      tracked.add(new Tracked(stage.visuals().get(i)));
    }
    tracked.forEach(this::follow);
  }

  private void follow(Tracked one) {
    int parts = parts(one.visual);
    if (one.figure == null || one.parts != parts) {
      if (one.figure != null) {
        one.figure.node().detach();
      }
      one.parts = parts;
      one.figure = Figure.whole(one.visual);
      locale.addBranchGraph(one.figure.node());
    }
    one.figure.capture();
    one.figure.show();
  }

  private static int parts(Visual visual) {
    return visual.parts().stream().mapToInt(part -> 1 + parts(part)).sum();
  }

  /** Java 3D's eye looks along -z with x to the right: its axes are the eye's z, y and -x. */
  private void point(Placement worldFromEye) {
    for (int row = 0; row < 3; row++) {
      matrix[4 * row] = worldFromEye.rotation(row, 2);
      matrix[4 * row + 1] = worldFromEye.rotation(row, 1);
      matrix[4 * row + 2] = -worldFromEye.rotation(row, 0);
    }
    matrix[3] = worldFromEye.xM();
    matrix[7] = worldFromEye.yM();
    matrix[11] = worldFromEye.zM();
    matrix[15] = 1;
    eye.setTransform(new Transform3D(matrix));
  }

  private Film film(Picture picture) {
    for (Film film : films) {
      if (film.fits(picture)) {
        return film;
      }
    }
    synchronized (UniverseLock.LOCK) {
      Film film = new Film(picture.width(), picture.height(), eye);
      films.add(film);
      return film;
    }
  }

  @Override
  public void dispose() {
    synchronized (UniverseLock.LOCK) {
      VirtualUniverse.removeRenderingErrorListener(errors);
      films.forEach(Film::close);
      universe.removeAllLocales();
    }
  }
}
