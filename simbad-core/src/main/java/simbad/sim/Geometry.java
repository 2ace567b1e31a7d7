package simbad.sim;

/** A name that Simbad has; nothing is in it. */
public class Geometry {
  /** Creates an instance, of which there is no use. */
  public Geometry() {}
}
