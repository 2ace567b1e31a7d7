package simbad.sim;

import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;

/** Two legs with a beam across: 4 m wide, 2 m high, a passage of 2 m by 1.5 m along z. */
public class Arch extends BlockWorldCompositeObject {
  private static final float LEG_HEIGHT_M = 1.5f;
  private static final double LEG_X_M = 1.5;

  /**
   * Creates an arch.
   *
   * @param position middle of the passage, on the floor, metres; copied
   * @param environment gives the colour
   */
  public Arch(Vector3d position, EnvironmentDescription environment) {
    placement().moveTo(position.x, position.y, position.z);
    Vector3f leg = new Vector3f(1, LEG_HEIGHT_M, 1);
    addBlock(new Vector3d(-LEG_X_M, 0, 0), leg, environment);
    addBlock(new Vector3d(LEG_X_M, 0, 0), leg, environment);
    addBlock(new Vector3d(0, LEG_HEIGHT_M, 0), new Vector3f(4, 0.5f, 1), environment);
  }

  private void addBlock(Vector3d position, Vector3f sides, EnvironmentDescription environment) {
    addChild(new Box(position, sides, environment, environment.archColor));
  }
}
