package simbad.kernel.scene;

import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.Ray;

/**
 * All solids of a world. Not safe for use by several threads; after the first query following a
 * change of membership, queries allocate nothing.
 */
public final class BodyScene {
  private static final Solid NOBODY = new Solid(new Placement());

  private final SolidIndex fixed = new SolidIndex();
  private final SolidIndex moving = new SolidIndex();

  /** Creates an empty scene. */
  public BodyScene() {}

  /** Adds a solid that seldom moves. If it was in another scene, it leaves that one. */
  public void addFixed(Solid solid) {
    fixed.add(solid);
  }

  /** Adds a solid that moves often. If it was in another scene, it leaves that one. */
  public void addMoving(Solid solid) {
    moving.add(solid);
  }

  /**
   * Shortens a ray to the nearest surface within its length.
   *
   * @param ray in the world frame
   * @return true if the ray met something
   */
  public boolean strike(Ray ray) {
    return strike(ray, NOBODY);
  }

  /**
   * Shortens a ray to the nearest surface within its length.
   *
   * @param ray in the world frame
   * @param except a solid that the ray passes through
   * @return true if the ray met something
   */
  public boolean strike(Ray ray, Solid except) {
    boolean struck = fixed.strike(ray, except);
    return moving.strike(ray, except) || struck;
  }

  /**
   * Finds what rays that stay inside a ball can meet.
   *
   * @param ball the ball
   * @param except a solid that the rays pass through; always the same one for the same {@code near}
   * @param near is filled anew; keep it for the next time
   */
  public void gather(Ball ball, Solid except, Neighbourhood near) {
    near.keep(fixed, ball, except);
    moving.gather(ball, except, near);
  }

  /**
   * Returns true if a ball is stopped by a present, non-traversable solid that was added as fixed.
   *
   * @param ball the ball
   * @param clearance what is known from earlier calls for a ball that moves little in between
   */
  public boolean stopsBall(Ball ball, Clearance clearance) {
    return !clearance.isFree(fixed, ball)
        && fixed.stopsBall(ball.xM(), ball.yM(), ball.zM(), ball.radiusM());
  }

  /**
   * Returns true if a ball is stopped by a present, non-traversable solid that was added as fixed.
   *
   * @param xM x of the ball's centre, metres
   * @param yM height of its centre, metres
   * @param zM z of its centre, metres
   * @param radiusM its radius, metres
   */
  public boolean stopsBall(double xM, double yM, double zM, double radiusM) {
    return fixed.stopsBall(xM, yM, zM, radiusM);
  }
}
