package simbad.sim;

/** A name that Simbad has; there is no gripper, and no program can make one. */
public class GripperActuator extends ActuatorDevice {
  GripperActuator() {}
}
