package simbad.sim;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

/** A box with its long side along x until it is turned. */
public class Wall extends Box {
  private static final float DEFAULT_WIDTH_M = 0.3f;

  /**
   * Creates a wall 0.3 m thick.
   *
   * @param position middle of the bottom face, metres; copied
   * @param length along x, metres
   * @param height metres
   * @param environment gives the colour
   */
  public Wall(Vector3d position, float length, float height, EnvironmentDescription environment) {
    this(position, length, DEFAULT_WIDTH_M, height, environment);
  }

  /**
   * Creates a wall.
   *
   * @param position middle of the bottom face, metres; copied
   * @param length along x, metres
   * @param width along z, metres
   * @param height metres
   * @param environment gives the colour
   */
  public Wall(
      Vector3d position,
      float length,
      float width,
      float height,
      EnvironmentDescription environment) {
    super(position, new Vector3f(length, height, width), environment, environment.wallColor);
  }
}
