package simbad.sim;

import org.jspecify.annotations.Nullable;
import simbad.kernel.drawing.Stage;
import simbad.kernel.geometry.Placement;
import simbad.kernel.render.Picture;
import simbad.kernel.render.PictureSource;

/** Takes the pictures of all cameras of a world. Safe for use by several threads. */
final class WorldCameras {
  private final Stage stage;
  private @Nullable PictureSource source;

  WorldCameras(Stage stage) {
    this.stage = stage;
  }

  /** Takes a picture; the first one decides by whom, see {@link CameraKind#choose(boolean)}. */
  synchronized void take(boolean shown, Placement worldFromEye, Picture picture) {
    if (source == null) {
      source = CameraKind.choose(shown).open(stage);
    }
    source.take(worldFromEye, picture);
  }

  synchronized void dispose() {
    if (source != null) {
      source.dispose();
      source = null;
    }
  }
}
