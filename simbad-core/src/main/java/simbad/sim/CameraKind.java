package simbad.sim;

import simbad.kernel.drawing.Stage;
import simbad.kernel.render.PictureSource;
import simbad.kernel.render.SoftwareCamera;

/** Who takes the pictures of cameras and light sensors. */
enum CameraKind {
  /** Plain arithmetic: needs no display, the same bytes everywhere. */
  SOFTWARE {
    @Override
    PictureSource open(Stage stage) {
      return new SoftwareCamera(stage);
    }
  };

  abstract PictureSource open(Stage stage);

  static CameraKind fromProperty() {
    return SOFTWARE;
  }
}
