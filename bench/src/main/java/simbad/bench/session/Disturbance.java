package simbad.bench.session;

import java.io.IOException;

/**
 * The conversation with the board went wrong though the line is still there: nothing came in time,
 * or what came does not fit what was asked. {@link Ranger#settle} begins anew.
 */
public final class Disturbance extends IOException {
  private static final long serialVersionUID = 1;

  /**
   * Creates one.
   *
   * @param what went wrong, for people
   */
  public Disturbance(String what) {
    super(what);
  }
}
