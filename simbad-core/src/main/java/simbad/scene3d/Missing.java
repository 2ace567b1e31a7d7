package simbad.scene3d;

import javax.media.j3d.Canvas3D;

/** Says what Java 3D lacks here, in one line. */
final class Missing {
  private static final String AWT = "java.desktop/sun.awt";

  private Missing() {}

  static DisplayException display() {
    return new DisplayException(
        "no 3D view: there is no display (on a machine without one, run under xvfb-run)",
        new IllegalStateException("headless"));
  }

  static DisplayException openGl(String why) {
    return new DisplayException(
        "no 3D view: OpenGL is missing or fails: " + why, new IllegalStateException(why));
  }

  static DisplayException frame(Throwable failure) {
    return new DisplayException("the world is not drawn; is its window hidden?", failure);
  }

  /** Finds out what a failure to start Java 3D comes from. */
  static DisplayException of(Throwable failure) {
    if (failure instanceof DisplayException known) {
      return known;
    }
    if (!isAwtExported()) {
      return new DisplayException(
          "no 3D view: Java was started without --add-exports=" + AWT + "=ALL-UNNAMED", failure);
    }
    Throwable root = failure;
    while (root.getCause() != null) {
      root = root.getCause();
    }
    String why = root.getMessage() == null ? root.getClass().getSimpleName() : root.getMessage();
    return root instanceof UnsatisfiedLinkError
        ? new DisplayException(
            "no 3D view: a native library is missing: " + why.lines().findFirst().orElse(""),
            failure)
        : openGl(why);
  }

  private static boolean isAwtExported() {
    return ModuleLayer.boot()
        .findModule("java.desktop")
        .map(desktop -> desktop.isExported("sun.awt", Canvas3D.class.getModule()))
        .orElse(false);
  }
}
