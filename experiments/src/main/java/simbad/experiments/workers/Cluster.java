package simbad.experiments.workers;

import java.io.IOException;

/**
 * A kind of workers on other machines: a class with a public constructor without arguments that a
 * jar names in {@code META-INF/services/simbad.experiments.workers.Cluster}.
 */
public interface Cluster {
  /**
   * Reaches the workers.
   *
   * @param master where to ask for them, such as {@code spark://host:7077}
   * @throws IOException if there are none
   */
  Workers connect(String master) throws IOException;
}
