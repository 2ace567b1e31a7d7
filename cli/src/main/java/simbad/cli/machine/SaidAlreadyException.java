package simbad.cli.machine;

import java.io.IOException;

/** The work failed, and who did it has said why: nothing is left to say. */
public final class SaidAlreadyException extends IOException {
  private static final long serialVersionUID = 1;

  /** Has no message. */
  public SaidAlreadyException() {
    super("said already");
  }
}
