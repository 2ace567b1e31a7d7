package simbad.kernel.scene;

import org.jspecify.annotations.Nullable;

/**
 * The free space round a body, as it was found last: as long as the body stays in it, nothing that
 * stands still can stop it, and the scene need not be asked. Not safe for use by several threads.
 */
public final class Clearance {
  /** How far beyond the body to look, as a share of its radius. */
  private static final double SLACK = 0.5;

  private final Ball free = new Ball();
  private @Nullable SolidIndex index;
  private int revision;

  /** Creates a clearance of which nothing is known. */
  public Clearance() {}

  /** Returns true if no part can touch a ball; false says nothing. */
  boolean isFree(SolidIndex asked, Ball ball) {
    if (index != asked || revision != asked.revision() || !free.holds(ball)) {
      index = asked;
      revision = asked.revision();
      double radiusM = ball.radiusM() * (1 + SLACK);
      boolean clear = asked.isFree(ball.xM(), ball.yM(), ball.zM(), radiusM);
      free.set(ball.xM(), ball.yM(), ball.zM(), clear ? radiusM : -1);
      return clear;
    }
    return true;
  }
}
