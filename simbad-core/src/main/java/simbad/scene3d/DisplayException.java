package simbad.scene3d;

/** There can be no 3D view here; the message names what is missing. */
public final class DisplayException extends RuntimeException {
  private static final long serialVersionUID = 1;

  DisplayException(String message, Throwable cause) {
    super(message, cause);
  }

  private DisplayException(String message) {
    // Without a stack trace a program that ends with it says this one line.
    super(message, null, false, false);
  }

  /** Returns what a program ends with that wants a window where there is none. */
  public static DisplayException noWindow() {
    return new DisplayException(
        "there is no display for the window; without one, type: ./simbad program PROGRAM");
  }
}
