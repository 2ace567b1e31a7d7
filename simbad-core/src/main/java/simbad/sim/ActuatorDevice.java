package simbad.sim;

/** A device that acts. */
public abstract class ActuatorDevice extends Device {
  ActuatorDevice() {}
}
