package simbad.sim;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import simbad.kernel.drawing.Stage;
import simbad.kernel.render.PictureSource;
import simbad.kernel.render.SoftwareCamera;
import simbad.scene3d.OffscreenCamera;

/** Who takes the pictures of cameras and light sensors. */
enum CameraKind {
  /** Plain arithmetic: needs no display, the same bytes everywhere. */
  SOFTWARE {
    @Override
    PictureSource open(Stage stage) {
      return new SoftwareCamera(stage);
    }
  },

  /** Java 3D, which needs a display. Its classes are not touched before this is opened. */
  JAVA3D {
    @Override
    PictureSource open(Stage stage) {
      return OffscreenCamera.open(stage);
    }
  };

  /** The system property that says which one; without it, Java 3D if a window shows the world. */
  static final String PROPERTY = "simbad.camera";

  /**
   * Opens a source of pictures.
   *
   * @throws simbad.scene3d.DisplayException if it cannot work here
   */
  abstract PictureSource open(Stage stage);

  /**
   * Chooses a kind.
   *
   * @param shown whether a window shows the world
   * @throws IllegalArgumentException if the property names none
   */
  static CameraKind choose(boolean shown) {
    return Optional.ofNullable(System.getProperty(PROPERTY))
        .map(CameraKind::named)
        .orElse(shown ? JAVA3D : SOFTWARE);
  }

  private static CameraKind named(String name) {
    return Arrays.stream(values())
        .filter(kind -> kind.propertyName().equals(name))
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(unknown(name)));
  }

  private static String unknown(String name) {
    return Arrays.stream(values())
        .map(CameraKind::propertyName)
        .collect(Collectors.joining(", ", PROPERTY + " = " + name + " is none of ", ""));
  }

  private String propertyName() {
    return name().toLowerCase(Locale.ROOT);
  }
}
