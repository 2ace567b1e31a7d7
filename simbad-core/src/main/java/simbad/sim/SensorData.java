package simbad.sim;

/** What a sensor has measured, as a value that can be copied. */
public abstract class SensorData implements Cloneable {
  /** Creates an instance. */
  public SensorData() {}

  /** Returns an independent copy. */
  @Override
  public abstract Object clone();
}
