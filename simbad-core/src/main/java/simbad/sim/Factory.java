package simbad.sim;

/** A class whose static methods make things. */
public abstract class Factory {
  /** Creates a factory. */
  public Factory() {}
}
