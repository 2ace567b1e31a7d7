package simbad.blindworld.world;

/** Rows before a world, ready to be read any number of times. */
public interface Repeats {

  /** One set of readings of all rows; infinite is a no-echo. The same seed gives the same. */
  double[] read(long seed);
}
