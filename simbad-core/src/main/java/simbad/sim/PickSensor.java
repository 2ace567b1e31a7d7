package simbad.sim;

import javax.media.j3d.BranchGroup;
import org.jspecify.annotations.Nullable;

/** A sensor that looks for objects along rays. Programs may derive their own from it. */
public abstract class PickSensor extends SensorDevice {
  /** The drawn scene, if a window draws one. Sensing does not need it. */
  protected @Nullable BranchGroup pickableSceneBranch;

  /** Creates a sensor. */
  public PickSensor() {}

  /** Says which drawn scene the sensor is in. */
  protected void setPickableSceneBranch(@Nullable BranchGroup branch) {
    pickableSceneBranch = branch;
  }
}
