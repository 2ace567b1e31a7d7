package simbad.sim;

/** A device that senses. */
public abstract class SensorDevice extends Device {
  SensorDevice() {}
}
