package simbad.scene3d;

import java.util.Optional;
import javax.media.j3d.RenderingErrorListener;
import javax.media.j3d.VirtualUniverse;
import org.jspecify.annotations.Nullable;

/**
 * What Java 3D's threads complain about. Java 3D's own answer to it is to end the process, as long
 * as nobody else listens.
 */
final class DrawingErrors {
  private static volatile @Nullable String last;

  static {
    VirtualUniverse.addRenderingErrorListener(error -> last = error.getErrorMessage());
  }

  private DrawingErrors() {}

  /** Keeps errors from ending the process from now on, and forgets earlier ones. */
  static void await() {
    last = null;
  }

  /** Returns the latest error since {@link #await()}. */
  static Optional<String> findLast() {
    return Optional.ofNullable(last);
  }

  static void add(RenderingErrorListener listener) {
    VirtualUniverse.addRenderingErrorListener(listener);
  }

  static void remove(RenderingErrorListener listener) {
    VirtualUniverse.removeRenderingErrorListener(listener);
  }
}
