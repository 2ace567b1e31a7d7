package simbad.scene3d;

/** There can be no 3D view here; the message names what is missing. */
public final class DisplayException extends RuntimeException {
  private static final long serialVersionUID = 1;

  DisplayException(String message, Throwable cause) {
    super(message, cause);
  }
}
