package simbad.sim;

import javax.vecmath.Vector3d;

/** A robot whose behaviour methods are public. */
public class Robot extends Agent {
  /**
   * Creates a robot.
   *
   * @param pos where its base stands at the start, metres; copied
   * @param name its name
   */
  public Robot(Vector3d pos, String name) {
    super(pos, name);
  }

  @Override
  public void initBehavior() {
    super.initBehavior();
  }

  @Override
  public void performBehavior() {
    super.performBehavior();
  }
}
